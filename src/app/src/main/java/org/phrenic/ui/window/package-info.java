/** The window: menus, docks, files, preferences, status. */
package org.phrenic.ui.window;
