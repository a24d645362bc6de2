/** Colours, materials and visibility of structures. */
package org.phrenic.scene.style;
