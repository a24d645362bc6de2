/** Straight paths from the skin to a target: what they cross at one moment, over a breath, and from anywhere. */
package org.phrenic.access.path;
