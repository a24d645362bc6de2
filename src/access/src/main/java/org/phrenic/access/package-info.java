/**
 * Liver access: moving anatomy with no-go zones, liver tissue points, needle, target lesion and breath cycle. Paths,
 * attempts and plans are in the subpackages.
 */
package org.phrenic.access;
