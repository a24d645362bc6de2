/** Per-vertex quantities of surfaces that shading needs. */
package org.phrenic.scene.surface;
