/**
 * Reports as HTML and Markdown pages, with the disclaimer that every report contains. Independent of the content of the
 * reports.
 */
package org.phrenic.document.report;
