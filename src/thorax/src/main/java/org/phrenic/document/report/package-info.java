/**
 * Reports as HTML and Markdown pages, with the disclaimer that every report carries. Knows nothing of what is reported.
 */
package org.phrenic.document.report;
