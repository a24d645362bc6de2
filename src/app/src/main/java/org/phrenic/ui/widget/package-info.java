/** Swing components with no knowledge of a simulation. */
package org.phrenic.ui.widget;
