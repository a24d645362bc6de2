/** Rehearsal mode: its docks and its session. */
package org.phrenic.ui.access;
