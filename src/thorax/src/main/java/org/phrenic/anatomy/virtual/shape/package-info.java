/** Geometric building blocks of the virtual thorax: curves, tubes, fields, relaxation. */
package org.phrenic.anatomy.virtual.shape;
