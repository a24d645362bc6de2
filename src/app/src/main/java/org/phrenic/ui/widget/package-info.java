/** Swing components, dialogs and colours of one style. They may use preferences, and know nothing of a simulation. */
package org.phrenic.ui.widget;
