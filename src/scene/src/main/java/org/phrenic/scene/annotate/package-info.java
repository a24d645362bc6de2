/** Annotations over a picture: orientation, scale bar, colour bar, text. Uses Java 2D only. */
package org.phrenic.scene.annotate;
