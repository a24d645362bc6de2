package org.phrenic.model.organ;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.MeshMeasure;

/**
 * Anchors of the base of the lungs on the thoracic face of the diaphragm, which slide along it. As the diaphragm peels
 * off the chest wall, the costodiaphragmatic recess opens and the lung border descends to the line where diaphragm and
 * wall still touch.
 *
 * <p>From the point of the face nearest to each base vertex a track of points follows the muscle fibres down to the
 * insertion, with a spacing of {@value RecessTracks#SPACING_MM} mm at rest ({@link RecessTracks}). The opening of a
 * track point rises from 0 at its rest distance from the wall to 1 at {@value #OPEN_MM} mm more; {@code S} is the
 * opened length of the track within the zone of apposition. The vertex descends its track by {@code S f(a)}, where
 * {@code a} is the distance from the vertex to the upper end of that zone and {@code f} falls linearly from 1 to 0 over
 * {@value #REACH_MM} mm. The border slides fully and the middle of the base not at all.
 *
 * <p>Anchors are computed from the current nodes and follow them without jumps. The lung exerts no force on the
 * diaphragm, because it is two orders of magnitude softer.
 */
public final class LungBaseMotion implements PrescribedMotion {
    /**
     * The sheet is apposed where it is nearer to the wall than this. The pleura leaves no gap, but the input surfaces
     * are smoothed.
     */
    private static final double APPOSED_MM = 8;

    private static final double LATERAL = 0.5;
    /**
     * A track that comes back to the wall after more points than these, as one from the flank over the tendon to the
     * xiphoid, slides where it comes back. Shorter gaps are dents of the surfaces.
     */
    private static final int LONGEST_GAP = 8;

    /** A vertex farther from the face, as of a lung above fluid, is carried without sliding. */
    private static final double FAR_MM = 15;

    private static final double OPEN_MM = 15;
    private static final double REACH_MM = 140;
    /** Time constant with which anchors approach their target positions without jumps. */
    private static final double RELAXATION_S = 0.04;
    /** After a longer interval the anchors are reset to their targets. */
    private static final double MAX_INTERVAL_S = 0.2;

    /** Number of values per wall plane. */
    private static final int PLANE = 5;

    private static final int POINTS_A_PIECE = 128;

    private final ParticleSystem system;
    private final ContactSurface wall;
    /** Nodes under the tracks, as offsets into positions, and the distance of each from the wall minus that at rest. */
    private final int[] trackNodes;

    private final double[] gapAtRest;
    private final double[] gapOpening;
    /** Indices of the track nodes that determine the opening of the tracks. */
    private int[] openingNodes;

    private final double[] plane;
    /**
     * For each track: its first point, its first apposed point, and the share {@code f} of the sliding that the vertex
     * follows.
     */
    private final int[] start;

    private final int[] firstApposedPoint;
    private final double[] slidingShare;
    /** For each point: three track nodes and their weights. */
    private final int[] corner;

    private final double[] weight;
    /** For each point: the sheet's normal at rest. Unlike the normal of a moving triangle it does not oscillate. */
    private final double[] normal;
    /** For each vertex: distance from the face along its normal, and the remaining offset. */
    private final double[] normalOffset;

    private final double[] tangentialOffset;
    /** Anchor positions at the last evaluation, their velocities, and their target positions. */
    private final double[] anchor;

    private final double[] speed;
    private final double[] target;
    private double lastTime = Double.NaN;
    /** {@link #anchor}, {@link #speed} and {@link #target} one after another, as saved last, and the time of that. */
    private final double[] saved;

    private double savedTime = Double.NaN;
    private double elapsedS;
    private final Workers.Task openTask = this::updateOpening;
    private final Workers.Task carryTask = this::moveAnchors;

    /**
     * @param points vertices of the base at rest, three numbers each, mm
     * @param tracks lines from these points down the face
     */
    public LungBaseMotion(
            ParticleSystem system, DiaphragmPart part, MovingChestWall chest, double[] points, RecessTracks tracks) {
        this.system = system;
        Diaphragm sheet = part.diaphragm;
        NodeLayout layout = system.layout();
        int n = points.length / 3;
        int[] vertices = Arrays.stream(tracks.corner).distinct().sorted().toArray();
        trackNodes = Arrays.stream(vertices)
                .map(v -> 3 * layout.internal(part.firstNode + v))
                .toArray();
        corner = Arrays.stream(tracks.corner)
                .map(v -> Arrays.binarySearch(vertices, v))
                .toArray();
        weight = tracks.weight;
        start = tracks.start;
        wall = chest.limitingContact(
                MassSpringBuilder.positionsOf(sheet.sheet().positions(), 0, vertices), new double[vertices.length]);
        gapAtRest = new double[vertices.length];
        gapOpening = new double[vertices.length];
        plane = new double[PLANE * vertices.length];
        double[] rest = sheet.sheet().positions();
        double[] normals = MeshMeasure.vertexNormals(sheet.sheet());
        double[] outward = new double[vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            int k = 3 * vertices[i];
            outward[i] = chest.outwardComponent(rest[k], rest[k + 1], normals[k], normals[k + 1]);
        }
        normal = new double[weight.length];
        for (int p = 0; p < normal.length / 3; p++) {
            interpolateNormal(p, vertices, normals);
        }
        wall.prepare(0);
        openingNodes = IntStream.range(0, trackNodes.length).toArray();
        updateOpening();
        System.arraycopy(gapOpening, 0, gapAtRest, 0, gapOpening.length);
        firstApposedPoint = new int[n];
        slidingShare = new double[n];
        findApposedPoints(outward);
        Arrays.fill(gapOpening, 0);
        openingNodes = openingNodes();
        normalOffset = new double[n];
        anchor = new double[3 * n];
        speed = new double[3 * n];
        target = new double[3 * n];
        saved = new double[3 * anchor.length];
        tangentialOffset = new double[3 * n];
        measureOffsets(points);
    }

    /** Finds the first apposed point of each track and the share of the sliding that its vertex follows. */
    private void findApposedPoints(double[] outward) {
        for (int i = 0; i < slidingShare.length; i++) {
            int p = firstApposed(
                    start[i], start[i + 1], q -> at(q, gapAtRest) < APPOSED_MM && at(q, outward) > LATERAL);
            firstApposedPoint[i] = p;
            slidingShare[i] = Math.max(0, 1 - RecessTracks.SPACING_MM * (p - start[i]) / REACH_MM);
        }
    }

    /** The first point from which on a track lies on the wall, but for short gaps; its end if there is none. */
    static int firstApposed(int from, int to, IntPredicate apposed) {
        int first = to;
        int last = to;
        for (int q = from; q < to; q++) {
            if (apposed.test(q)) {
                first = last == to || q - last > LONGEST_GAP ? q : first;
                last = q;
            }
        }
        return first;
    }

    /** Computes the distance of each vertex from the face along its normal, and the remaining offset. */
    private void measureOffsets(double[] points) {
        for (int i = 0; i < normalOffset.length; i++) {
            int first = start[i];
            for (int axis = 0; axis < 3; axis++) {
                tangentialOffset[3 * i + axis] = points[3 * i + axis] - interpolate(first, axis, system.positions());
                normalOffset[i] += tangentialOffset[3 * i + axis] * normal[3 * first + axis];
            }
            if (normalOffset[i] > FAR_MM) {
                normalOffset[i] = 0;
                slidingShare[i] = 0;
            }
            for (int axis = 0; axis < 3; axis++) {
                tangentialOffset[3 * i + axis] -= normalOffset[i] * normal[3 * first + axis];
            }
        }
    }

    /** Track nodes around the apposed part of the tracks along which a vertex slides. */
    private int[] openingNodes() {
        boolean[] tells = new boolean[trackNodes.length];
        for (int i = 0; i < slidingShare.length; i++) {
            for (int c = 3 * firstApposedPoint[i]; c < 3 * start[i + 1] && slidingShare[i] > 0; c++) {
                tells[corner[c]] = true;
            }
        }
        return IntStream.range(0, tells.length).filter(i -> tells[i]).toArray();
    }

    private void interpolateNormal(int point, int[] vertices, double[] normals) {
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            for (int c = 3 * point; c < 3 * point + 3; c++) {
                normal[3 * point + axis] += weight[c] * normals[3 * vertices[corner[c]] + axis];
            }
            squared += normal[3 * point + axis] * normal[3 * point + axis];
        }
        for (int axis = 0; axis < 3; axis++) {
            normal[3 * point + axis] /= Math.max(Math.sqrt(squared), Double.MIN_NORMAL);
        }
    }

    private double at(int point, double[] values) {
        return weight[3 * point] * values[corner[3 * point]]
                + weight[3 * point + 1] * values[corner[3 * point + 1]]
                + weight[3 * point + 2] * values[corner[3 * point + 2]];
    }

    /** Updates the distance of the opening nodes from the wall, minus that at rest. */
    private void updateOpening() {
        system.workers().run(pieces(openingNodes.length), openTask);
    }

    private void updateOpening(int piece) {
        double[] x = system.positions();
        int end = Math.min(openingNodes.length, (piece + 1) * POINTS_A_PIECE);
        for (int t = piece * POINTS_A_PIECE; t < end; t++) {
            int i = openingNodes[t];
            int k = trackNodes[i];
            int p = PLANE * i;
            wall.tangentPlane(i, x[k], x[k + 1], x[k + 2], plane, p);
            gapOpening[i] =
                    plane[p] * x[k] + plane[p + 1] * x[k + 1] + plane[p + 2] * x[k + 2] - plane[p + 3] - gapAtRest[i];
        }
    }

    private static int pieces(int points) {
        return (points + POINTS_A_PIECE - 1) / POINTS_A_PIECE;
    }

    @Override
    public int pointCount() {
        return slidingShare.length;
    }

    @Override
    public void at(double time, double[] position, double[] velocity) {
        wall.prepare(time);
        updateOpening();
        elapsedS = time - lastTime;
        system.workers().run(pieces(slidingShare.length), carryTask);
        lastTime = time;
        System.arraycopy(anchor, 0, position, 0, anchor.length);
        System.arraycopy(speed, 0, velocity, 0, speed.length);
    }

    @Override
    public void saveMotion() {
        int n = anchor.length;
        System.arraycopy(anchor, 0, saved, 0, n);
        System.arraycopy(speed, 0, saved, n, n);
        System.arraycopy(target, 0, saved, 2 * n, n);
        savedTime = lastTime;
    }

    @Override
    public void restoreMotion() {
        int n = anchor.length;
        System.arraycopy(saved, 0, anchor, 0, n);
        System.arraycopy(saved, n, speed, 0, n);
        System.arraycopy(saved, 2 * n, target, 0, n);
        lastTime = savedTime;
    }

    private void moveAnchors(int piece) {
        double[] x = system.positions();
        boolean anew = !(elapsedS > 0 && elapsedS < MAX_INTERVAL_S);
        int end = Math.min(slidingShare.length, (piece + 1) * POINTS_A_PIECE);
        for (int i = piece * POINTS_A_PIECE; i < end; i++) {
            double along = slidingShare[i] > 0 ? slidingShare[i] * openedPoints(i) : 0;
            int last = start[i + 1] - 1;
            int point = Math.min(start[i] + (int) along, Math.max(start[i], last - 1));
            double t = last == start[i] ? 0 : Math.min(1, start[i] + along - point);
            int next = t > 0 ? point + 1 : point;
            for (int axis = 0; axis < 3; axis++) {
                int c = 3 * i + axis;
                double place = (1 - t) * interpolate(point, axis, x) + t * interpolate(next, axis, x);
                double up = (1 - t) * normal[3 * point + axis] + t * normal[3 * next + axis];
                double to = place + normalOffset[i] * up + tangentialOffset[c];
                anchor[c] = anew ? to : anchor[c] + elapsedS * speed[c];
                speed[c] = anew ? 0 : (to - target[c]) / elapsedS + (to - anchor[c]) / RELAXATION_S;
                target[c] = to;
            }
        }
    }

    /** Opened length of a track, in points. */
    private double openedPoints(int track) {
        double sum = 0;
        for (int p = firstApposedPoint[track]; p < start[track + 1]; p++) {
            double u = Math.max(0, Math.min(1, at(p, gapOpening) / OPEN_MM));
            sum += u * u * (3 - 2 * u);
        }
        return sum;
    }

    /** Current coordinate of a track point. */
    private double interpolate(int point, int axis, double[] of) {
        return weight[3 * point] * of[trackNodes[corner[3 * point]] + axis]
                + weight[3 * point + 1] * of[trackNodes[corner[3 * point + 1]] + axis]
                + weight[3 * point + 2] * of[trackNodes[corner[3 * point + 2]] + axis];
    }

    /**
     * Lung nodes on the base, the nearest diaphragm node of each, and the stiffness that ties each to its place there.
     */
    public record BaseSprings(List<Integer> nodes, List<Integer> nearest, List<Double> stiffness) {
        public int[] node() {
            return nodes.stream().mapToInt(Integer::intValue).toArray();
        }

        public int[] nearestVertex() {
            return nearest.stream().mapToInt(Integer::intValue).toArray();
        }

        public double[] stiffnesses() {
            return stiffness.stream().mapToDouble(Double::doubleValue).toArray();
        }
    }
}
