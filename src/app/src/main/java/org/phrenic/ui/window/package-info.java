/**
 * The window: frame, menus, tool bar, status bar, messages, files, and the arrangement of docks. Nothing else uses it
 * but the command line.
 */
package org.phrenic.ui.window;
