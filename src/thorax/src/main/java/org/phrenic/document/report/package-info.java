/** Reports as HTML and Markdown pages, with the notice that every report carries. */
package org.phrenic.document.report;
