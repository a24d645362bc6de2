/**
 * Style of a scene: colours, colour maps, visibility, clip plane, and display names of structures. No OpenGL and no
 * camera.
 */
package org.phrenic.scene.style;
