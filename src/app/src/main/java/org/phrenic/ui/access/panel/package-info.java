/** Sections, verdicts and report cards of rehearsal mode. */
package org.phrenic.ui.access.panel;
