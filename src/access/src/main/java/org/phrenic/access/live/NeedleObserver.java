package org.phrenic.access.live;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleShaft;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;

/** Describes the needle and the probe of a live rehearsal at a frame, for display. */
final class NeedleObserver {
    /**
     * A needle that is not placed.
     *
     * @param entry where it will be placed; empty if nothing is chosen
     * @param angles how it is held there; empty if it points at the target
     */
    record Planned(Optional<SkinPoint> entry, Optional<NeedleAngles> angles) {}

    private final MovingAnatomy anatomy;
    private final RehearsalPlan plan;
    private final PathAnalyzer analyzer;

    NeedleObserver(MovingAnatomy anatomy, RehearsalPlan plan) {
        this.anatomy = anatomy;
        this.plan = plan;
        analyzer = new PathAnalyzer(anatomy, plan.needle());
    }

    /**
     * The state at a frame; a needle that points more than 45 degrees aside of the target is judged over its length.
     */
    NeedleState describe(
            NeedleInsertion needle, HeldProbe probe, Planned planned, Frame frame, RespiratoryPhase phase) {
        NeedleShaft shaft = needle.shaft();
        double[] centre = needle.targetNow();
        boolean placed = shaft.isPlaced();
        Optional<double[]> from =
                placed ? Optional.of(shaft.entry()) : planned.entry().map(SkinPoint::current);
        double[] start = from.orElse(centre);
        double[] direction = placed
                ? shaft.direction()
                : planned.angles().map(NeedleAngles::direction).orElseGet(() -> toward(start, centre));
        double along = Vectors.dot(Vectors.subtract(centre, start), direction);
        double depth = placed ? shaft.depth() : 0;
        double lengthMm = plan.needle().lengthMm();
        double ahead = placed ? Math.max(Math.min(along, lengthMm), depth) : along;
        double beside = Vectors.distanceToLine(centre, start, direction);
        double aimed = along > Math.max(Needle.LEAST_AIM_MM, beside) ? ahead : lengthMm;
        double[] end = Vectors.addScaled(start, direction, aimed);
        Optional<PathAnalysis> path = from.map(skin -> analyzer.analyze(skin, end));
        boolean reaches =
                path.isPresent() && !plan.needle().isShorterThan(path.get().lengthMm());
        PathAnalyzer.Margin margin =
                reaches ? analyzer.margin(start, end, plan.avoided()) : new PathAnalyzer.Margin(0, "");
        return new NeedleState(
                frame.timeS(),
                phase,
                centre,
                needle.target().radiusMm(),
                from,
                placed,
                Vectors.addScaled(start, direction, depth - lengthMm),
                Vectors.addScaled(start, direction, depth),
                depth,
                aimed,
                needle.isMoving(),
                placed ? Optional.of(needle.targetingError()) : Optional.empty(),
                path.map(p -> p.reasons(plan.avoided(), plan.needle())).orElse(List.of()),
                margin.mm(),
                anatomy.labelOf(margin.nearest()),
                placed ? needle.warnings() : List.of(),
                needle.record().samples().size(),
                NeedleAngles.of(direction),
                probe.hold()
                        .map(hold -> new ProbeState(
                                hold,
                                probe.pose().orElseThrow(),
                                depth > 0 && probe.isTipSeen(needle),
                                inBeam(probe, needle))),
                needle.load());
    }

    /** Angles of the needle, or of the planned one. */
    static NeedleAngles angles(NeedleInsertion needle, Planned planned) {
        double[] target = needle.targetNow();
        if (needle.shaft().isPlaced()) {
            return NeedleAngles.of(needle.shaft().direction());
        }
        return planned.angles()
                .orElseGet(() -> NeedleAngles.of(
                        toward(planned.entry().map(SkinPoint::current).orElse(target), target)));
    }

    private static double inBeam(HeldProbe probe, NeedleInsertion needle) {
        return needle.shaft().isPlaced() && needle.shaft().depth() > 0 ? probe.needleInBeamMm(needle) : 0;
    }

    private static double[] toward(double[] from, double[] to) {
        double[] line = Vectors.subtract(to, from);
        return Vectors.length(line) > 0 ? Vectors.normalize(line) : new double[] {0, 0, 1};
    }
}
