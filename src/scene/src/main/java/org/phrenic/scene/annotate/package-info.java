/** What is written over a picture: orientation, ruler, colour bar, text. Java 2D only. */
package org.phrenic.scene.annotate;
