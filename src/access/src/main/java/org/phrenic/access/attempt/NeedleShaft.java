package org.phrenic.access.attempt;

import java.util.Optional;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.SkinPoint;
import org.phrenic.mesh.Vectors;

/**
 * Pose of a straight, rigid needle in the body. The needle passes through a fixed point of the moving skin and keeps
 * its direction in space. While the tip is anchored in the liver, it moves with the tissue and the needle rotates about
 * the skin point.
 */
public final class NeedleShaft {
    private final LiverTissue tissue;
    private final double lengthMm;
    private Optional<SkinPoint> skin = Optional.empty();
    private double[] entry = new double[3];
    private double[] direction = new double[3];
    private double depth;
    private Optional<LiverTissue.Point> tip = Optional.empty();
    private LiverTissue.Point capsule;
    private double capsuleDepth;
    private double[] directionAtCapsule = new double[3];
    private int placements;

    NeedleShaft(LiverTissue tissue, double lengthMm) {
        this.tissue = tissue;
        this.lengthMm = lengthMm;
    }

    /** Places the tip on the skin and points the needle at {@code aim}. */
    void place(SkinPoint point, double[] from, double[] aim) {
        skin = Optional.of(point);
        entry = from;
        depth = 0;
        tip = Optional.empty();
        placements++;
        pointAt(aim);
    }

    /** How often the needle has been placed on the skin. */
    int placements() {
        return placements;
    }

    void remove() {
        skin = Optional.empty();
        tip = Optional.empty();
    }

    void pointAt(double[] aim) {
        direction = Vectors.normalize(Vectors.subtract(aim, entry));
    }

    /**
     * Follows skin and tissue to the current frame; where the hub then lies on the skin, tissue that moves farther away
     * slips off the tip. Returns the change of depth, mm.
     */
    double followTissue() {
        entry = skin.orElseThrow().current();
        if (tip.isEmpty()) {
            return 0;
        }
        double[] line = Vectors.subtract(tissue.position(tip.get()), entry);
        double length = Vectors.length(line);
        double before = depth;
        direction = Vectors.normalize(line);
        if (length > lengthMm) {
            moveTo(lengthMm);
        } else {
            depth = length;
        }
        return depth - before;
    }

    /** Moves the tip to a depth. An anchored tip is anchored again at the new depth. */
    void moveTo(double toDepthMm) {
        depth = toDepthMm;
        tip = tip.map(anchor -> tissue.pointNowAt(tip()));
    }

    /** Anchors the tip in the tissue. {@code capsuleDepthMm} is the depth at which the needle crosses the capsule. */
    void anchorTip(double capsuleDepthMm) {
        tip = Optional.of(tissue.pointNowAt(tip()));
        capsule = tissue.pointNowAt(at(capsuleDepthMm));
        capsuleDepth = capsuleDepthMm;
        directionAtCapsule = direction;
    }

    void releaseTip() {
        tip = Optional.empty();
    }

    /** Whether the needle is on or in the body. */
    public boolean isPlaced() {
        return skin.isPresent();
    }

    /** Whether the tip is in the liver. */
    public boolean isTipAnchored() {
        return tip.isPresent();
    }

    /** Depth of the tip below the skin, along the needle, mm. */
    public double depth() {
        return depth;
    }

    /** Point where the needle passes through the skin, LPS, mm; read-only. */
    public double[] entry() {
        return entry;
    }

    /** Unit vector from skin to tip; read-only. */
    public double[] direction() {
        return direction;
    }

    public double[] tip() {
        return at(depth);
    }

    /** Position at a depth below the skin, LPS, mm. */
    public double[] at(double depthMm) {
        return Vectors.addScaled(entry, direction, depthMm);
    }

    /** Distance of the needle from its puncture point in the capsule, mm; 0 while the tip is not in the liver. */
    public double capsulePullMm() {
        return tip.isEmpty() ? 0 : Vectors.distanceToLine(tissue.position(capsule), entry, direction);
    }

    /** Depth at which the needle went through the capsule, mm; that of its latest puncture. */
    double capsuleDepthMm() {
        return capsuleDepth;
    }

    /** Rotation caused by the liver since capsule puncture, degrees; 0 while the tip is not in the liver. */
    public double rotationByLiverDeg() {
        return tip.isEmpty() ? 0 : Vectors.angleDeg(direction, directionAtCapsule);
    }
}
