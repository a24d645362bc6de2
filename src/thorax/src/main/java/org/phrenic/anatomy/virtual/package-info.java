/** The virtual thorax: structures generated from a table of measures. */
package org.phrenic.anatomy.virtual;
