package org.phrenic.access.plan;

import org.phrenic.access.ultrasound.ProbePose;

/**
 * The ultrasound probe of a live rehearsal at one frame, for display.
 *
 * @param hold how it is held
 * @param pose where it is
 * @param tipInBeam whether the tip of the needle is in the body and in the beam
 * @param needleInBeamMm length of the needle below the skin that is in the beam, mm
 */
public record ProbeState(ProbeHold hold, ProbePose pose, boolean tipInBeam, double needleInBeamMm) {}
