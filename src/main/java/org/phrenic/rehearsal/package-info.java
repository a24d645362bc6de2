/**
 * Rehearsing liver access: a needle on its way through the breathing thorax to a target in the liver. {@link org.phrenic.rehearsal.MovingScene} is the body as a frame shows it, {@link org.phrenic.rehearsal.PathReader}
 * says what a straight path crosses, {@link org.phrenic.rehearsal.AccessMap} from where on the skin a target can be reached, {@link org.phrenic.rehearsal.NeedleSession} is an attempt, step by step, and
 * {@link org.phrenic.rehearsal.AttemptRecord} its record. For research and training only, not for clinical use.
 */
package org.phrenic.rehearsal;
