/** Docks that tune and show a simulation. */
package org.phrenic.ui.dock;
