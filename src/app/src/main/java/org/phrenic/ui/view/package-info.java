/** The 3D view and the thread that draws it. */
package org.phrenic.ui.view;
