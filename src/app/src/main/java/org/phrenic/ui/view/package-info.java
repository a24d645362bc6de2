/**
 * The 3D view: its component, its camera control, the style of the scene and the thread that renders it. No dock and no
 * dialog.
 */
package org.phrenic.ui.view;
