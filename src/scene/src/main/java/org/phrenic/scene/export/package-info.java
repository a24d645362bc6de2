/** Writers of picture and movie files. Independent of the scene packages. */
package org.phrenic.scene.export;
