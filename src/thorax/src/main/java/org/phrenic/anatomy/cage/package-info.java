/** Ribs, sternum and chest wall: helical axes, poses, bone weights. */
package org.phrenic.anatomy.cage;
