package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.Needle;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Vectors;

/**
 * State of a live rehearsal at one frame, for display. Positions are LPS, mm. Arrays are read-only.
 *
 * @param target centre of the target
 * @param entry entry point of the needle, or the chosen entry point; empty if none is chosen
 * @param placed whether the needle is on or in the body
 * @param hub hub of the needle; before placement, of the planned needle
 * @param tip tip of the needle; before placement, of the planned needle
 * @param depthMm depth of the tip below the skin, mm
 * @param aimedDepthMm length of the path that is judged, mm: the depth at which the needle passes nearest to the
 *     target, or that of its tip if it is deeper; the length of a needle that points more than 45 degrees aside of it
 * @param targetingError targeting error; empty before placement
 * @param reasons reasons why the path that is judged is not free, as text; empty if it is free
 * @param marginMm margin of the path to the avoided zones, mm; 0 if it is not free
 * @param nearest label of the structure that limits the margin; empty if there is none
 * @param warnings warnings about the needle in the body, as text
 * @param samples samples taken so far
 * @param angles angles of the needle; before placement, of the planned needle
 * @param probe the ultrasound probe; empty while it is not on the skin
 * @param load loads on the needle
 */
public record NeedleState(
        double timeS,
        RespiratoryPhase label,
        double[] target,
        double targetRadiusMm,
        Optional<double[]> entry,
        boolean placed,
        double[] hub,
        double[] tip,
        double depthMm,
        double aimedDepthMm,
        boolean moving,
        Optional<TargetingError> targetingError,
        List<String> reasons,
        double marginMm,
        String nearest,
        List<String> warnings,
        int samples,
        NeedleAngles angles,
        Optional<ProbeState> probe,
        NeedleLoad load) {
    /** Whether the tip is in the liver. */
    public boolean inLiver() {
        return load.inLiver();
    }

    /** Whether there is a needle to display. */
    public boolean hasNeedle() {
        return entry.isPresent();
    }

    /**
     * Depth at which the needle passes nearest to the target where that is at the moment, mm; at least
     * {@link Needle#LEAST_AIM_MM}.
     */
    public double targetDepthMm() {
        double[] toTarget = Vectors.subtract(target, entry.orElse(target));
        return Math.max(Needle.LEAST_AIM_MM, Vectors.dot(toTarget, angles.direction()));
    }
}
