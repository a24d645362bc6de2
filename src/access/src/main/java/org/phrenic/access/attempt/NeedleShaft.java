package org.phrenic.access.attempt;

import java.util.Optional;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.SkinPoint;
import org.phrenic.mesh.Vectors;

/**
 * How a straight, rigid needle lies in a body: through a point of the skin that moves with it, in a direction that is
 * kept in the room, and from the liver's capsule on with its tip in the tissue: then the tip goes where that tissue
 * goes and the needle turns about its point in the skin.
 */
final class NeedleShaft {
    private final LiverTissue tissue;
    private Optional<SkinPoint> skin = Optional.empty();
    private double[] entry = new double[3];
    private double[] direction = new double[3];
    private double depth;
    private Optional<LiverTissue.Point> tip = Optional.empty();
    private LiverTissue.Point capsule;
    private double[] directionAtCapsule = new double[3];

    NeedleShaft(LiverTissue tissue) {
        this.tissue = tissue;
    }

    /** Its tip is on the skin and points at a place. */
    void place(SkinPoint point, double[] from, double[] aim) {
        skin = Optional.of(point);
        entry = from;
        depth = 0;
        tip = Optional.empty();
        pointAt(aim);
    }

    /** It is in no body. */
    void remove() {
        skin = Optional.empty();
        tip = Optional.empty();
    }

    /** Points at a place, about its point in the skin. */
    void pointAt(double[] aim) {
        direction = Vectors.normalize(Vectors.subtract(aim, entry));
    }

    /** The body has moved: skin and tissue take it along. How much deeper the tip is by that, mm. */
    double followTissue() {
        entry = skin.orElseThrow().current();
        if (tip.isEmpty()) {
            return 0;
        }
        double[] line = Vectors.subtract(tissue.position(tip.get()), entry);
        double length = Vectors.length(line);
        double deeper = length - depth;
        depth = length;
        direction = Vectors.normalize(line);
        return deeper;
    }

    /** The tip goes to a depth; from tissue to tissue where it is in the liver. */
    void moveTo(double toDepthMm) {
        depth = toDepthMm;
        tip = tip.map(held -> tissue.pointNowAt(tip()));
    }

    /** The tissue holds the tip from now on. */
    void anchorTip(double capsuleDepthMm) {
        tip = Optional.of(tissue.pointNowAt(tip()));
        capsule = tissue.pointNowAt(at(capsuleDepthMm));
        directionAtCapsule = direction.clone();
    }

    /** The tip is free. */
    void releaseTip() {
        tip = Optional.empty();
    }

    boolean isPlaced() {
        return skin.isPresent();
    }

    /** Whether the tip is in the liver. */
    boolean isTipAnchored() {
        return tip.isPresent();
    }

    /** Depth of the tip below the skin, along the needle, mm. */
    double depth() {
        return depth;
    }

    /** Where it goes through the skin, LPS, mm; not to be written to. */
    double[] entry() {
        return entry;
    }

    /** Unit vector from skin to tip; not to be written to. */
    double[] direction() {
        return direction;
    }

    /** Where the tip is, LPS, mm. */
    double[] tip() {
        return at(depth);
    }

    /** The place at a depth below the skin, LPS, mm. */
    double[] at(double depthMm) {
        return Vectors.addScaled(entry, direction, depthMm);
    }

    /**
     * Distance between the needle and where it went through the capsule, which has moved with the liver, mm; 0 while
     * the tip is not held.
     */
    double capsulePullMm() {
        return tip.isEmpty() ? 0 : Vectors.distanceToLine(tissue.position(capsule), entry, direction);
    }

    /**
     * How far the liver has turned the needle since it went through the capsule, degrees; 0 while the tip is not held.
     */
    double rotationByLiverDeg() {
        return tip.isEmpty() ? 0 : Vectors.angleDeg(direction, directionAtCapsule);
    }
}
