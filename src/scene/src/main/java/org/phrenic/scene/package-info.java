/** Pictures of a scene: what is drawn, frames and recordings. */
package org.phrenic.scene;
