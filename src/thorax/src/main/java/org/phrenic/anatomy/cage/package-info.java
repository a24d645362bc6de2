/**
 * Motion of the rib cage: ends and helical axes of ribs, poses of the bones at a time, skinning weights of the points
 * they carry, and the inner chest wall that moves with them. No forces.
 */
package org.phrenic.anatomy.cage;
