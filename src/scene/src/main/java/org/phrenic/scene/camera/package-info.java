/** Camera, transforms, bounding boxes, tiles and ray picking. No OpenGL. */
package org.phrenic.scene.camera;
