/**
 * Rigid motions and bodies that move along helical axes. Motion is prescribed, not solved, and does not depend on
 * forces.
 */
package org.phrenic.engine.kinematics;
