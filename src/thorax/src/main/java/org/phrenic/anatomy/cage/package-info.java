/**
 * Kinematics of the rib cage: ends and helical axes of ribs, poses of the bones, skinning weights, and the moving inner
 * chest wall. Contains no forces.
 */
package org.phrenic.anatomy.cage;
