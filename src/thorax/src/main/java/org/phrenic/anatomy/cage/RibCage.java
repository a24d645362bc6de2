package org.phrenic.anatomy.cage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.engine.kinematics.RigidMotion;

/**
 * The bones as rigid bodies on helical axes with one common amplitude. Ribs follow a {@link RibAxisTable}; the sternum
 * has the best-fit rigid motion of the anterior ends of ribs 1 to 7; the trunk (spine) is fixed. Costal cartilages are
 * not bodies: they are blended between rib and sternum ({@link SkinningWeights}).
 */
public final class RibCage {
    /** Index of the fixed body. */
    public static final int TRUNK = 0;

    private static final int LAST_TRUE_RIB = 7;

    /**
     * One rigid body.
     *
     * @param name name of its structure, or {@code trunk} or {@code sternum}
     * @param level level of a rib, 0 otherwise
     * @param side side of a rib
     * @param axis motion to full inspiration; empty for the trunk
     * @param ends ends of a rib; empty otherwise
     */
    public record Body(String name, int level, Side side, Optional<HelicalAxis> axis, Optional<RibEnds> ends) {}

    private final MedianFrame frame;
    private final List<Body> bodies;
    private final HelicalBody[] motions;

    private RibCage(MedianFrame frame, List<Body> bodies) {
        this.frame = frame;
        this.bodies = List.copyOf(bodies);
        motions = new HelicalBody[bodies.size()];
        for (int i = 0; i < motions.length; i++) {
            motions[i] = bodies.get(i).axis().map(HelicalBody::new).orElse(null);
        }
    }

    /**
     * Creates bodies for the trunk, the ribs of a thorax and, if at least three true ribs are present, its sternum.
     *
     * @param movingSternum false to make the sternum part of the fixed trunk
     */
    public static RibCage of(Thorax thorax, RibAxisTable table, boolean movingSternum) {
        MedianFrame frame = MedianFrame.of(thorax);
        List<Body> bodies = new ArrayList<>();
        bodies.add(new Body("trunk", 0, Side.MIDLINE, Optional.empty(), Optional.empty()));
        List<Structure> ribs = thorax.structuresOf(StructureKind.RIB);
        List<RibEnds> found = ribs.parallelStream()
                .map(rib -> RibEnds.find(rib.mesh(), rib.side()))
                .toList();
        for (int i = 0; i < ribs.size(); i++) {
            Structure rib = ribs.get(i);
            RibEnds ends = found.get(i);
            HelicalAxis axis = frame.toScan(table.axis(rib.level(), rib.side(), frame.toFrame(ends.head())));
            bodies.add(new Body(rib.name(), rib.level(), rib.side(), Optional.of(axis), Optional.of(ends)));
        }
        boolean led = bodies.stream().filter(RibCage::leadsSternum).count() >= 3;
        if (movingSternum && led && !thorax.structuresOf(StructureKind.STERNUM).isEmpty()) {
            HelicalAxis axis = sternumAxis(bodies, body -> body.axis().orElseThrow());
            bodies.add(new Body("sternum", 0, Side.MIDLINE, Optional.of(axis), Optional.empty()));
        }
        return new RibCage(frame, bodies);
    }

    /** Frame of the body. */
    public MedianFrame frame() {
        return frame;
    }

    private static boolean leadsSternum(Body body) {
        return body.ends().isPresent() && body.level() <= LAST_TRUE_RIB;
    }

    /** Best-fit rigid motion of the anterior ends of the true ribs, each of which rotates about its axis. */
    private static HelicalAxis sternumAxis(List<Body> bodies, Function<Body, HelicalAxis> axes) {
        List<Body> ribs = bodies.stream().filter(RibCage::leadsSternum).toList();
        double[] from = new double[3 * ribs.size()];
        double[] to = new double[from.length];
        for (int i = 0; i < ribs.size(); i++) {
            double[] end = ribs.get(i).ends().orElseThrow().anterior();
            System.arraycopy(end, 0, from, 3 * i, 3);
            double[] moved = axes.apply(ribs.get(i)).motion().apply(end[0], end[1], end[2]);
            System.arraycopy(moved, 0, to, 3 * i, 3);
        }
        return HelicalAxis.of(RigidMotion.fit(from, to));
    }

    public List<Body> bodies() {
        return bodies;
    }

    /** Index of the body of a rib, or -1. */
    public int rib(int level, Side side) {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).level() == level && bodies.get(i).side() == side) {
                return i;
            }
        }
        return -1;
    }

    /** Index of the body of the sternum, or of the trunk if there is none. */
    public int sternum() {
        return bodies.get(bodies.size() - 1).name().equals("sternum") ? bodies.size() - 1 : TRUNK;
    }

    /**
     * Motions of all bodies with the bucket-handle component of each rib's rotation (about the antero-posterior axis)
     * scaled by a factor; null for a fixed body. The axis still passes through the rib's head. The sternum follows the
     * ribs.
     */
    HelicalBody[] motions(double bucket) {
        if (bucket == 1) {
            return motions;
        }
        HelicalBody[] other = new HelicalBody[motions.length];
        Function<Body, HelicalAxis> scaled =
                body -> frame.toScan(scaleBucketHandle(frame.toFrame(body.axis().orElseThrow()), bucket));
        for (int i = 0; i < other.length; i++) {
            other[i] = bodies.get(i).ends().isPresent() ? new HelicalBody(scaled.apply(bodies.get(i))) : null;
        }
        if (sternum() != TRUNK) {
            other[sternum()] = new HelicalBody(sternumAxis(bodies, scaled));
        }
        return other;
    }

    private static HelicalAxis scaleBucketHandle(HelicalAxis axis, double bucket) {
        double[] turn = {axis.directionX(), bucket * axis.directionY(), axis.directionZ()};
        double length = Math.sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
        return HelicalAxis.through(
                turn, new double[] {axis.pointX(), axis.pointY(), axis.pointZ()}, length * axis.angle(), axis.slide());
    }
}
