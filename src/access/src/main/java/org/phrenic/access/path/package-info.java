/** Straight paths to a target: what they cross, over the breath and over the skin. */
package org.phrenic.access.path;
