/** Camera, transforms, bounding boxes, picture tiles and ray picking. No OpenGL. */
package org.phrenic.scene.camera;
