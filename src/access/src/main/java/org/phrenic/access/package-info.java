/**
 * Liver access: the moving anatomy with its no-go zones and tissue points, the needle, the target lesion and the breath
 * cycle. No paths, attempts or plans; those are in the packages below.
 */
package org.phrenic.access;
