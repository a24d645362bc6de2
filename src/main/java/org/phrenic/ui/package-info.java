/** The window: a breathing thorax in the middle, docks around it, and what connects them to the running simulation. */
package org.phrenic.ui;
