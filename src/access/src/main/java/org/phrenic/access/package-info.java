/** Liver access: moving anatomy, needle, target lesion, no-go zones. */
package org.phrenic.access;
