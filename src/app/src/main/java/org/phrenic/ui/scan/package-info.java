/**
 * Import of a scan in the window: labels and options are chosen in a dialog, the import runs beside the present scene,
 * a summary lists what was built, and the body opens.
 */
package org.phrenic.ui.scan;
