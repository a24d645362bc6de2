/** Cameras, views, rays and picking. */
package org.phrenic.scene.camera;
