package org.phrenic.access.attempt;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.Crossing;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;

/**
 * Simulates the insertion of a needle into a breathing body. The needle is placed on the skin, advanced, redirected and
 * withdrawn, and takes samples. The body moves from frame to frame. The result depends only on the frames and on the
 * commands between them. A manual attempt and a planned attempt with the same commands therefore give the same record.
 *
 * <p>The needle is straight. It passes through a fixed point of the moving skin and keeps its direction in space. The
 * capsule of the liver is pushed by some millimetres before it is cut; until then the tip is not in the liver. Inside
 * the liver, the tip moves with the tissue between advances and the needle rotates about the skin point. The
 * displacement at the capsule, the rotation and the {@link NeedleLoad} are recorded; the load moves nothing. Bone stops
 * the tip and the throw of a core.
 *
 * <p>Not thread-safe.
 */
public final class NeedleInsertion {
    private static final double TOLERANCE_MM = 1e-9;

    private final MovingAnatomy anatomy;
    private final LiverTissue tissue;
    private final TargetLesion target;
    private final LiverTissue.Point targetCentre;
    private final Needle needle;
    private final PathAnalyzer analyzer;
    private final WayAhead ahead;
    private final AttemptLog log;
    private final NeedleShaft shaft;
    private final TipMotion motion = new TipMotion();
    /** Whether the needle has been turned since its tip was last moved. */
    private boolean turned;

    /**
     * @param anatomy already updated to a frame; later frames must be passed to {@link #update}
     * @param avoided zones for which the time of contact is recorded
     */
    public NeedleInsertion(MovingAnatomy anatomy, TargetLesion target, Needle needle, Set<NoGoZone> avoided) {
        this.anatomy = anatomy;
        this.target = target;
        this.needle = needle;
        tissue = new LiverTissue(anatomy);
        targetCentre = tissue.pointAtRest(target.restMm());
        shaft = new NeedleShaft(tissue, needle.lengthMm());
        analyzer = new PathAnalyzer(anatomy, needle);
        ahead = new WayAhead(anatomy, analyzer, needle, shaft);
        log = new AttemptLog(avoided);
    }

    /** Advances to a frame. The body moves first, then the tip with its tissue, then the needle as commanded. */
    public void update(Frame frame, RespiratoryPhase phase) {
        double elapsed = log.update(frame, phase);
        anatomy.update(frame);
        log.trackTarget(targetNow());
        if (!shaft.isPlaced()) {
            return;
        }
        log.tipDrifted(shaft.followTissue());
        double before = shaft.depth();
        advanceTip(elapsed);
        registerContacts(before, elapsed);
        if (shaft.isTipAnchored()) {
            log.capsulePulled(shaft.capsulePullMm(), shaft.rotationByLiverDeg());
        }
    }

    private void advanceTip(double elapsed) {
        if (!motion.isMoving()) {
            return;
        }
        double depth = shaft.depth();
        double next = motion.reach(depth, elapsed);
        Optional<Crossing> bone = next > depth ? ahead.boneBefore(next) : Optional.empty();
        if (bone.isPresent()) {
            next = Math.max(depth, bone.get().fromMm());
            log.event(AttemptEvent.Kind.BONE_CONTACT, bone.get().label(), next);
            motion.stop();
        }
        log.travelled(Math.abs(next - depth));
        shaft.moveTo(next);
    }

    /** Records punctures and newly entered structures, and anchors or releases the tip. */
    private void registerContacts(double before, double elapsed) {
        double depth = shaft.depth();
        double frameBefore = log.timeS() - elapsed;
        if (before == 0 && depth > 0) {
            log.event(AttemptEvent.Kind.SKIN_PUNCTURE, "", 0, frameBefore);
            log.skinPunctured(frameBefore);
        }
        if (before > 0 && depth == 0) {
            log.event(AttemptEvent.Kind.OUT_OF_SKIN, "", 0);
            log.withdrawn();
            shaft.remove();
        }
        if (depth == 0) {
            return;
        }
        PathAnalysis path = analyzer.analyze(shaft.entry(), shaft.tip());
        log.addExposure(path, elapsed);
        Optional<Crossing> liver = Optional.empty();
        for (Crossing c : path.crossings()) {
            boolean isLiver = c.kind() == StructureKind.LIVER;
            boolean holdsTip = isLiver && c.toMm() >= depth - TOLERANCE_MM;
            double cutMm = isLiver ? c.fromMm() + NeedleLoad.capsulePushMm(needle) : c.fromMm();
            boolean pushed = holdsTip && !shaft.isTipAnchored() && depth < cutMm;
            if (!pushed && log.isFirstEntry(c.name())) {
                double share = depth > before ? (cutMm - before) / (depth - before) : 1;
                double when = log.timeS() - elapsed * (1 - Math.max(0, Math.min(1, share)));
                AttemptEvent.Kind kind = isLiver ? AttemptEvent.Kind.CAPSULE_PUNCTURE : AttemptEvent.Kind.ENTERS;
                log.event(kind, c.label(), cutMm, when);
            }
            if (holdsTip && !pushed) {
                liver = Optional.of(c);
            }
        }
        if (liver.isEmpty()) {
            shaft.releaseTip();
        } else if (!shaft.isTipAnchored()) {
            shaft.anchorTip(liver.get().fromMm());
        }
        log.loaded(loadOf(before, path));
    }

    private NeedleLoad loadOf(double before, PathAnalysis path) {
        NeedleLoad side = shaft.isTipAnchored()
                ? NeedleLoad.aside(needle, shaft.capsulePullMm(), shaft.capsuleDepthMm())
                : NeedleLoad.NONE;
        double depth = shaft.depth();
        return depth > before
                ? NeedleLoad.advancing(needle, before, depth, path.crossings(), shaft.isTipAnchored(), side)
                : side;
    }

    /** Loads on the needle at the last frame. */
    public NeedleLoad load() {
        return shaft.isPlaced() ? log.load() : NeedleLoad.NONE;
    }

    /**
     * Places the tip on the skin and points the needle at a position. A needle in the body is withdrawn first.
     *
     * @param entry position near the skin in the current frame
     * @throws BadInputException if the entry is not on the skin or the needle is too short; the state is then unchanged
     */
    public void place(double[] entry, double[] aim) {
        place(SkinPoint.current(anatomy.skin(), entry), aim);
    }

    /** Like {@link #place}, with the entry given at end-expiration. */
    public void placeAtRest(double[] entry, double[] aim) {
        place(SkinPoint.atRest(anatomy.skin(), entry), aim);
    }

    private void place(SkinPoint point, double[] aim) {
        double[] from = point.current();
        needle.requireReach(from, aim);
        if (shaft.depth() > 0) {
            log.travelled(shaft.depth());
            log.event(AttemptEvent.Kind.OUT_OF_SKIN, "", 0);
            log.withdrawn();
        }
        shaft.place(point, from, aim);
        motion.stop();
        turned = false;
        log.newAttempt();
        log.event(AttemptEvent.Kind.SKIN_CONTACT, "", 0);
    }

    /** Places the tip on the skin at an entry given at end-expiration, with the needle at these angles. */
    public void placeAtRest(double[] entry, NeedleAngles angles) {
        SkinPoint point = SkinPoint.atRest(anatomy.skin(), entry);
        place(point, Vectors.addScaled(point.current(), angles.direction(), needle.lengthMm() / 2));
    }

    /**
     * Turns the needle about its skin point to these angles. Turns between two movements of the tip are one
     * redirection; before the skin is punctured they are none.
     *
     * @throws BadInputException if the needle is not placed, or its tip is in the liver
     */
    public void turn(NeedleAngles angles) {
        requireTurnable();
        pointAt(Vectors.addScaled(shaft.entry(), angles.direction(), needle.lengthMm() / 2));
    }

    private void pointAt(double[] aim) {
        shaft.pointAt(aim);
        if (shaft.depth() > 0 && !turned) {
            log.event(AttemptEvent.Kind.REDIRECTION, "", shaft.depth());
        }
        turned = shaft.depth() > 0;
    }

    private void requireTurnable() {
        requirePlaced();
        if (shaft.isTipAnchored()) {
            throw new BadInputException("redirect: found the tip in the liver, expected it withdrawn from there first");
        }
    }

    /**
     * Depth below the skin at which the needle passes nearest to the centre of the target, mm; at least
     * {@link Needle#LEAST_AIM_MM}.
     */
    public double targetDepthMm() {
        double[] toTarget = Vectors.subtract(targetNow(), shaft.entry());
        return Math.max(Needle.LEAST_AIM_MM, Math.min(needle.lengthMm(), Vectors.dot(toTarget, shaft.direction())));
    }

    /**
     * Points the needle at another position by rotating it about its skin point. It counts like {@link #turn}.
     *
     * @throws BadInputException if the needle is not placed, its tip is in the liver, or it is too short
     */
    public void redirect(double[] aim) {
        requireTurnable();
        needle.requireReach(shaft.entry(), aim);
        pointAt(aim);
    }

    /**
     * Starts to move the tip to a depth below the skin, forward or backward.
     *
     * @param toDepthMm target depth, mm; 0 withdraws the needle
     * @param speedMmPerS positive speed, mm/s
     * @throws BadInputException if the needle is not placed, is too short, or a value is out of range
     */
    public void advance(double toDepthMm, double speedMmPerS) {
        requirePlaced();
        if (!(speedMmPerS > 0) || Double.isInfinite(speedMmPerS)) {
            throw new BadInputException("speed: found " + speedMmPerS + " mm/s, expected more than 0");
        }
        if (!(toDepthMm >= 0) || needle.isShorterThan(toDepthMm)) {
            throw new BadInputException(
                    "depth: found " + toDepthMm + " mm, expected 0 to the needle's " + needle.length());
        }
        turned = false;
        double goal = Math.min(toDepthMm, needle.lengthMm());
        if (!motion.start(shaft.depth(), goal, speedMmPerS) && goal == 0) {
            shaft.remove();
        }
    }

    /** The depth so many mm on from where the tip moves to, if it moves that way, or is; from 0 to the length. */
    public double depthAfter(double mm) {
        return Math.max(0, Math.min(needle.lengthMm(), motion.further(shaft.depth(), mm)));
    }

    /**
     * Takes a sample at the tip, or the core that is thrown from there.
     *
     * @throws BadInputException if the needle is not in the body
     */
    public TargetingError sample() {
        requirePlaced();
        if (shaft.depth() == 0) {
            throw new BadInputException("sample: found the needle outside of the body, expected it advanced first");
        }
        log.event(AttemptEvent.Kind.SAMPLE, shaft.isTipAnchored() ? "liver" : "", shaft.depth());
        OptionalDouble core = ahead.coreMm();
        TargetingError error = TargetingError.of(shaft, targetNow(), target, core);
        log.sampled(error);
        core.ifPresent(this::recordThrow);
        return error;
    }

    /** Records what a core of so many mm enters, comes near and touches beyond what the needle itself touches. */
    private void recordThrow(double coreMm) {
        double endMm = shaft.depth() + coreMm;
        PathAnalysis toEnd = analyzer.analyze(shaft.entry(), shaft.at(endMm));
        for (Crossing c : ahead.enteredByCore(toEnd)) {
            log.event(AttemptEvent.Kind.CORE_ENTERS, c.label(), Math.max(shaft.depth(), c.fromMm()));
        }
        ahead.boneInThrow().ifPresent(bone -> log.event(AttemptEvent.Kind.BONE_CONTACT, bone.label(), endMm));
        log.thrown(analyzer.analyze(shaft.entry(), shaft.tip()), toEnd);
    }

    private void requirePlaced() {
        if (!shaft.isPlaced()) {
            throw new BadInputException("needle: found it in no body, expected it placed on the skin first");
        }
    }

    /** The current pose of the needle. */
    public NeedleShaft shaft() {
        return shaft;
    }

    /** Position of the hub, LPS, mm. */
    public double[] hubNow() {
        return shaft.at(shaft.depth() - needle.lengthMm());
    }

    /** Whether the needle is advancing or being withdrawn. */
    public boolean isMoving() {
        return motion.isMoving();
    }

    /** Current centre of the target, LPS, mm. */
    public double[] targetNow() {
        return tissue.position(targetCentre);
    }

    public TargetingError targetingError() {
        return TargetingError.of(shaft, targetNow(), target, ahead.coreMm());
    }

    /** Current warnings, as short phrases: touched zones and displaced capsule. */
    public List<String> warnings() {
        return log.warnings(
                shaft.depth() > 0 ? Optional.of(analyzer.analyze(shaft.entry(), shaft.tip())) : Optional.empty(),
                shaft.capsulePullMm());
    }

    /** Time of the last frame, s. */
    public double timeS() {
        return log.timeS();
    }

    public TargetLesion target() {
        return target;
    }

    public Needle needle() {
        return needle;
    }

    /** The record up to the current frame. */
    public AttemptRecord record() {
        return log.record(target, needle);
    }
}
