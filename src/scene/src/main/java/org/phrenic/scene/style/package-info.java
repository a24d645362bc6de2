/**
 * How a scene looks: colours, colour maps, visibility, clip plane, and names of structures for people. No OpenGL and no
 * camera.
 */
package org.phrenic.scene.style;
