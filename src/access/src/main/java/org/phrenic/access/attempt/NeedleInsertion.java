package org.phrenic.access.attempt;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
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
import org.phrenic.simulation.observe.Frame;

/**
 * A needle in a breathing body, step by step: it is placed on the skin, advanced, redirected, withdrawn, and takes a
 * sample, while frames move the body on. What follows is a function of the frames and of the commands between them
 * alone, so an attempt in a window and one by plan give the same record if they are given the same.
 *
 * <p>The needle is straight and rigid and meets no friction. It goes through the skin at a point that moves with the
 * skin, and keeps its direction in the room as a hand would. From the liver's capsule on the tip stays with the tissue
 * that it is in: between advances it goes where that tissue goes, and the needle turns about its point in the skin. How
 * far the capsule is pulled aside by that, and the needle turned, is recorded as a warning; no force is worked out.
 * Bone stops the tip.
 *
 * <p>Used by one thread.
 */
public final class NeedleInsertion {
    private static final double STOPPED_MM = 1e-9;

    private final MovingAnatomy scene;
    private final LiverTissue tissue;
    private final TargetLesion target;
    private final LiverTissue.Point middle;
    private final Needle needle;
    private final PathAnalyzer reader;
    private final AttemptLog log;

    private final AttemptClock clock = new AttemptClock();
    private final NeedleShaft shaft;
    private double speed;
    private double goal;

    /**
     * @param scene that has taken a frame; the session takes all further ones
     * @param avoided what the needle should not touch; time spent in it is recorded
     */
    public NeedleInsertion(MovingAnatomy scene, TargetLesion target, Needle needle, Set<NoGoZone> avoided) {
        this.scene = scene;
        this.target = target;
        this.needle = needle;
        tissue = new LiverTissue(scene);
        middle = tissue.pointAtRest(target.restMm());
        shaft = new NeedleShaft(tissue);
        reader = new PathAnalyzer(scene, needle);
        log = new AttemptLog(avoided);
    }

    /**
     * Time goes on to a frame: the body moves, the tip with its tissue, then the needle as it was told to.
     *
     * @param doing what the breath is doing
     */
    public void update(Frame frame, RespiratoryPhase doing) {
        double passed = clock.update(frame, doing);
        scene.update(frame);
        log.trackTarget(targetNow());
        if (!shaft.isPlaced()) {
            return;
        }
        log.tipDrifted(shaft.followTissue());
        double before = shaft.depth();
        advanceTip(passed);
        registerContacts(before, passed);
        if (shaft.isTipAnchored()) {
            log.capsulePulled(capsulePullMm(), rotationByLiverDeg());
        }
    }

    private void advanceTip(double passed) {
        if (speed == 0) {
            return;
        }
        double depth = shaft.depth();
        double next = depth + Math.signum(goal - depth) * speed * passed;
        boolean arrives = (next - goal) * (depth - goal) <= 0;
        next = arrives ? goal : next;
        if (next > depth) {
            Optional<Crossing> bone = bone(next);
            if (bone.isPresent()) {
                next = Math.max(depth, bone.get().fromMm());
                event(AttemptEvent.Kind.BONE_CONTACT, bone.get().label(), next, clock.timeS());
                arrives = true;
            }
        }
        if (arrives) {
            speed = 0;
        }
        log.travelled(Math.abs(next - depth));
        shaft.moveTo(next);
    }

    /** The bone that stands in the way between here and there. */
    private Optional<Crossing> bone(double next) {
        double[] from = shaft.tip();
        double[] to = shaft.at(next);
        return scene.hazards().stream()
                .filter(s -> s.noGo().orElseThrow() == NoGoZone.BONE && s.boxDistance(from, to) <= 0)
                .flatMap(s -> reader.crossingsOf(s, shaft.entry(), to).stream())
                .filter(c -> c.fromMm() >= shaft.depth() - STOPPED_MM)
                .min(Comparator.comparingDouble(Crossing::fromMm));
    }

    /** Notes what the tip has come into, and takes hold of the tissue or lets it go. */
    private void registerContacts(double before, double passed) {
        double depth = shaft.depth();
        if (before == 0 && depth > 0) {
            event(AttemptEvent.Kind.SKIN_PUNCTURE, "", 0, timeS() - passed);
            log.skinPunctured(timeS() - passed);
        }
        if (before > 0 && depth == 0) {
            event(AttemptEvent.Kind.OUT_OF_SKIN, "", 0, timeS());
            log.withdrawn(timeS());
            shaft.remove();
        }
        if (depth == 0) {
            return;
        }
        PathAnalysis path = reader.analyze(shaft.entry(), tipNow());
        log.addExposure(path, passed);
        Optional<Crossing> liver = Optional.empty();
        for (Crossing c : path.crossings()) {
            boolean isLiver = c.kind() == StructureKind.LIVER;
            if (log.isFirstEntry(c.name())) {
                double share = depth > before ? (c.fromMm() - before) / (depth - before) : 1;
                double when = timeS() - passed * (1 - Math.max(0, Math.min(1, share)));
                event(
                        isLiver ? AttemptEvent.Kind.CAPSULE_PUNCTURE : AttemptEvent.Kind.ENTERS,
                        c.label(),
                        c.fromMm(),
                        when);
            }
            if (isLiver && c.toMm() >= depth - STOPPED_MM) {
                liver = Optional.of(c);
            }
        }
        if (liver.isEmpty()) {
            shaft.releaseTip();
        } else if (!shaft.isTipAnchored()) {
            shaft.anchorTip(liver.get().fromMm());
        }
    }

    private void event(AttemptEvent.Kind kind, String structure, double atDepth, double when) {
        log.add(clock.event(kind, structure, atDepth, when));
    }

    /**
     * Sets the tip on the skin, pointing at a place within. A needle that is in the body is taken out first.
     *
     * @param at within {@value SkinPoint#NEAR_MM} mm of the skin
     * @param aim where it points to
     * @throws BadInputException with one sentence, if the entry is not on the skin or the needle is too short; nothing
     *     has changed then
     */
    public void place(double[] at, double[] aim) {
        place(SkinPoint.current(scene.skin(), at), aim);
    }

    /** As {@link #place}, at a place of the skin that is given as it is at end-expiration. */
    public void placeAtRest(double[] at, double[] aim) {
        place(SkinPoint.atRest(scene.skin(), at), aim);
    }

    private void place(SkinPoint point, double[] aim) {
        double[] from = point.current();
        needle.requireReach(from, aim);
        if (shaft.depth() > 0) {
            withdrawAtOnce();
        }
        shaft.place(point, from, aim);
        speed = 0;
        log.newAttempt();
        event(AttemptEvent.Kind.SKIN_CONTACT, "", 0, timeS());
    }

    private void withdrawAtOnce() {
        log.travelled(shaft.depth());
        event(AttemptEvent.Kind.OUT_OF_SKIN, "", 0, timeS());
        log.withdrawn(timeS());
    }

    /**
     * Points the needle elsewhere; it turns about its point in the skin.
     *
     * @throws BadInputException with one sentence, if it is not placed, its tip is in the liver, or it is too short
     */
    public void redirect(double[] aim) {
        requirePlaced();
        if (shaft.isTipAnchored()) {
            throw new BadInputException("redirect: found the tip in the liver, expected it withdrawn from there first");
        }
        needle.requireReach(shaft.entry(), aim);
        shaft.pointAt(aim);
        event(AttemptEvent.Kind.REDIRECTION, "", shaft.depth(), timeS());
    }

    /**
     * From now on the tip goes to a depth below the skin and stops there, forth or back.
     *
     * @param toDepthMm 0 takes the needle out
     * @param speedMmPerS more than 0
     * @throws BadInputException with one sentence, if it is not placed, too short, or the numbers cannot be
     */
    public void advance(double toDepthMm, double speedMmPerS) {
        requirePlaced();
        if (!(speedMmPerS > 0) || Double.isInfinite(speedMmPerS)) {
            throw new BadInputException("speed: found " + speedMmPerS + " mm/s, expected more than 0");
        }
        if (!(toDepthMm >= 0) || toDepthMm > needle.lengthMm()) {
            throw new BadInputException(String.format(
                    Locale.ROOT,
                    "depth: found %.1f mm, expected 0 to the needle's %.0f mm",
                    toDepthMm,
                    needle.lengthMm()));
        }
        goal = toDepthMm;
        speed = goal == shaft.depth() ? 0 : speedMmPerS;
    }

    /** The needle stays as deep as it is. */
    public void stop() {
        speed = 0;
    }

    /**
     * Takes a sample where the tip is now.
     *
     * @throws BadInputException with one sentence, if the needle is not in the body
     */
    public TargetingError sample() {
        requirePlaced();
        if (shaft.depth() == 0) {
            throw new BadInputException("sample: found the needle outside of the body, expected it advanced first");
        }
        event(AttemptEvent.Kind.SAMPLE, shaft.isTipAnchored() ? "liver" : "", shaft.depth(), timeS());
        TargetingError miss = targetingError();
        log.sampled(miss, timeS());
        return miss;
    }

    private void requirePlaced() {
        if (!shaft.isPlaced()) {
            throw new BadInputException("needle: found it in no body, expected it placed on the skin first");
        }
    }

    /** Whether it is on or in the body. */
    public boolean isPlaced() {
        return shaft.isPlaced();
    }

    /** Whether it is being advanced or withdrawn. */
    public boolean isMoving() {
        return speed != 0;
    }

    /** Whether the tip is in the liver. */
    public boolean isInLiver() {
        return shaft.isTipAnchored();
    }

    /** Where the needle goes through the skin, LPS, mm; a copy. */
    public double[] entryNow() {
        return shaft.entry().clone();
    }

    /** Unit direction from skin to tip; a copy. */
    public double[] directionNow() {
        return shaft.direction().clone();
    }

    /** Where the tip is, LPS, mm. */
    public double[] tipNow() {
        return shaft.tip();
    }

    /** Where the hub is, LPS, mm. */
    public double[] hubNow() {
        return shaft.at(shaft.depth() - needle.lengthMm());
    }

    /** Depth of the tip below the skin, along the needle, mm. */
    public double depthMm() {
        return shaft.depth();
    }

    /** Where the middle of the target is, LPS, mm. */
    public double[] targetNow() {
        return tissue.position(middle);
    }

    /** How the tip lies to the target. */
    public TargetingError targetingError() {
        return TargetingError.of(tipNow(), shaft.direction(), targetNow(), target);
    }

    /**
     * What the path from the skin to a place meets as the body stands; for advice before and while the needle goes in.
     */
    public PathAnalysis readTo(double[] at) {
        return reader.analyze(shaft.entry(), at);
    }

    /** What a path from a place on the skin to another meets as the body stands. */
    public PathAnalysis read(double[] from, double[] to) {
        return reader.analyze(from, to);
    }

    /**
     * Distance between the needle and where it went through the capsule, which has moved with the liver, mm; 0 while it
     * is not in the liver.
     */
    public double capsulePullMm() {
        return shaft.capsulePullMm();
    }

    /**
     * How far the liver has turned the needle since it went through the capsule, degrees; 0 while it is not in the
     * liver.
     */
    public double rotationByLiverDeg() {
        return shaft.rotationByLiverDeg();
    }

    /** What is wrong at this moment, a few words each: in no-go structures, capsule pulled aside. */
    public List<String> warnings() {
        return log.warnings(
                shaft.depth() > 0 ? Optional.of(reader.analyze(shaft.entry(), tipNow())) : Optional.empty(),
                capsulePullMm());
    }

    /** Time of the last frame, s. */
    public double timeS() {
        return clock.timeS();
    }

    /** The scene as it stands. */
    public MovingAnatomy scene() {
        return scene;
    }

    /** The target. */
    public TargetLesion target() {
        return target;
    }

    /** The needle. */
    public Needle needle() {
        return needle;
    }

    /** The record so far. */
    public AttemptRecord record() {
        return log.record(target, needle, timeS());
    }
}
