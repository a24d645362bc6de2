/** The session that all parts of the window share: scenario, run, edits, undo. */
package org.phrenic.ui.session;
