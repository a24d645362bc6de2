/**
 * What is seen of a simulation: camera, colours, the renderer, what is written over its picture, what lies under the cursor, and pictures and movies as files. The same on a screen and without one.
 */
package org.phrenic.scene;
