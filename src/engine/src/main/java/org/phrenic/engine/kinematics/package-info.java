/** Rigid motions and bodies that move along helical axes: prescribed, not solved. Nothing here knows forces. */
package org.phrenic.engine.kinematics;
