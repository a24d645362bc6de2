/** What is painted over a picture: labels, scale bars, rulers. */
package org.phrenic.scene.annotate;
