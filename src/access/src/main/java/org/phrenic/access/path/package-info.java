/**
 * Straight paths from the skin to a target: crossed structures, margins over a breath, and the map of accessible
 * points.
 */
package org.phrenic.access.path;
