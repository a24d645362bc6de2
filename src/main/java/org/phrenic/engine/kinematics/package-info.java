/**
 * Floor 1: bodies whose motion is prescribed, not solved. Ribs turn about helical axes as one number, the depth of
 * inspiration, goes from 0 to 1. Nothing here allocates during a step.
 */
package org.phrenic.engine.kinematics;
