/** Docks of the researcher: parameters, breathing, forces, organs, display, stored settings. No rehearsal. */
package org.phrenic.ui.dock;
