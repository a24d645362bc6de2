/** The rehearsal of liver access in the window: its state, stages and commands. Components are in {@code panel}. */
package org.phrenic.ui.access;
