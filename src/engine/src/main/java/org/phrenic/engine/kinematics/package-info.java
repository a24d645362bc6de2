/** Rigid motions and bodies that turn on finite helical axes. */
package org.phrenic.engine.kinematics;
