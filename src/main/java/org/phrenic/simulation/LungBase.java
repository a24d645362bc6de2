package org.phrenic.simulation;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.ChestWall;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.Workers;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.geometry.MeshMeasure;

/**
 * Where the base of the lungs is held on the thoracic face of the diaphragm, and how it slides there: as the sheet leaves the chest wall, the costodiaphragmatic recess opens and the border of the lung comes down to where the two
 * still touch.
 *
 * <p>From the point of the face nearest to a vertex of the base a track of points runs down the sheet along its fibres to its insertion, {@value RecessTracks#SPACING_MM} mm apart at rest ({@link RecessTracks}). As a point leaves the wall it counts as open, from not at all where it is as
 * near as at rest to wholly at {@value #OPEN_MM} mm more; {@code S} is how much of the part of the track that lay against the wall at rest has opened. The vertex goes down its track by {@code S f(a)}, {@code a} the way from the vertex
 * to the upper end of that part and {@code f} falling evenly from 1 to 0 over {@value #REACH_MM} mm: the border slides wholly, the middle of the base not at all. Anchors are read off the nodes as they stand and follow them without jumps; the lung pulls on the diaphragm with
 * nothing, as it is two orders softer.
 */
final class LungBase implements PrescribedMotion {
    /** The sheet lies against the wall where it is nearer to it than this: the pleura is no gap, but given sheets are smoothed. */
    private static final double APPOSED_MM = 8;

    private static final double LATERAL = 0.5;
    private static final double OPEN_MM = 15;
    private static final double REACH_MM = 140;
    /** Anchors go on without a jump, and make up for what they are behind in this time. */
    private static final double CATCH_UP_S = 0.04;
    /** After longer they begin anew. */
    private static final double LONGEST_S = 0.2;

    /** Numbers of a plane of the wall. */
    private static final int PLANE = 5;

    private static final int POINTS_A_PIECE = 128;

    private final ParticleSystem system;
    private final ContactSurface wall;
    /** Nodes that the tracks run over, as offsets into positions; and how far each is from the wall, now less at rest. */
    private final int[] watched;

    private final double[] gapAtRest;
    private final double[] opening;
    /** Which of the watched nodes tell how far a track has opened. */
    private int[] telling;

    private final double[] plane;
    /** Of each track: its first point, the point where it comes to the wall, and the share of the sliding that the vertex takes. */
    private final int[] start;

    private final int[] apposed;
    private final double[] share;
    /** Of each point: three watched nodes and their weights. */
    private final int[] corner;

    private final double[] weight;
    /** Of each point: the sheet's normal at rest, which does not shake as that of a moving triangle does. */
    private final double[] normal;
    /** Of each vertex: distance from the face along its normal, and what is left. */
    private final double[] height;

    private final double[] aside;
    /** Where the anchors were when last asked for, how fast they went on from there, and where they ought to have been. */
    private final double[] anchor;

    private final double[] speed;
    private final double[] target;
    private double lastTime = Double.NaN;
    private double since;
    private final Workers.Task openTask = this::open;
    private final Workers.Task carryTask = this::carry;

    /**
     * @param points the base's vertices at rest, three numbers each, mm
     * @param tracks the lines from these points down the face
     */
    LungBase(ParticleSystem system, DiaphragmPart part, ChestWall chest, double[] points, RecessTracks tracks) {
        this.system = system;
        Diaphragm sheet = part.diaphragm;
        NodeLayout layout = system.layout();
        int n = points.length / 3;
        int[] vertices = Arrays.stream(tracks.corner).distinct().sorted().toArray();
        watched = Arrays.stream(vertices)
                .map(v -> 3 * layout.internal(part.first + v))
                .toArray();
        corner = Arrays.stream(tracks.corner)
                .map(v -> Arrays.binarySearch(vertices, v))
                .toArray();
        weight = tracks.weight;
        start = tracks.start;
        wall = chest.holding(SceneParts.points(sheet.sheet().positions(), 0, vertices), new double[vertices.length]);
        gapAtRest = new double[vertices.length];
        opening = new double[vertices.length];
        plane = new double[PLANE * vertices.length];
        double[] rest = sheet.sheet().positions();
        double[] normals = MeshMeasure.vertexNormals(sheet.sheet());
        double[] outward = new double[vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            int k = 3 * vertices[i];
            outward[i] = chest.outward(rest[k], rest[k + 1], normals[k], normals[k + 1]);
        }
        normal = new double[weight.length];
        for (int p = 0; p < normal.length / 3; p++) {
            takeNormal(p, vertices, normals);
        }
        wall.prepare(0);
        telling = IntStream.range(0, watched.length).toArray();
        open();
        System.arraycopy(opening, 0, gapAtRest, 0, opening.length);
        apposed = new int[n];
        share = new double[n];
        for (int i = 0; i < n; i++) {
            int p = start[i];
            while (p < start[i + 1] && !(at(p, gapAtRest) < APPOSED_MM && at(p, outward) > LATERAL)) {
                p++;
            }
            apposed[i] = p;
            share[i] = Math.max(0, 1 - RecessTracks.SPACING_MM * (p - start[i]) / REACH_MM);
        }
        Arrays.fill(opening, 0);
        telling = telling();
        height = new double[n];
        anchor = new double[3 * n];
        speed = new double[3 * n];
        target = new double[3 * n];
        aside = new double[3 * n];
        for (int i = 0; i < n; i++) {
            int first = start[i];
            for (int axis = 0; axis < 3; axis++) {
                aside[3 * i + axis] = points[3 * i + axis] - mean(first, axis, system.positions());
                height[i] += aside[3 * i + axis] * normal[3 * first + axis];
            }
            for (int axis = 0; axis < 3; axis++) {
                aside[3 * i + axis] -= height[i] * normal[3 * first + axis];
            }
        }
    }

    /** The watched nodes about the apposed part of those tracks that a vertex goes down. */
    private int[] telling() {
        boolean[] tells = new boolean[watched.length];
        for (int i = 0; i < share.length; i++) {
            for (int c = 3 * apposed[i]; c < 3 * start[i + 1] && share[i] > 0; c++) {
                tells[corner[c]] = true;
            }
        }
        return IntStream.range(0, tells.length).filter(i -> tells[i]).toArray();
    }

    private void takeNormal(int point, int[] vertices, double[] normals) {
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

    /** Forms the distance of the telling nodes from the wall less that at rest. */
    private void open() {
        system.workers().run(pieces(telling.length), openTask);
    }

    private void open(int piece) {
        double[] x = system.positions();
        int end = Math.min(telling.length, (piece + 1) * POINTS_A_PIECE);
        for (int t = piece * POINTS_A_PIECE; t < end; t++) {
            int i = telling[t];
            int k = watched[i];
            int p = PLANE * i;
            wall.planeNear(i, x[k], x[k + 1], x[k + 2], plane, p);
            opening[i] =
                    plane[p] * x[k] + plane[p + 1] * x[k + 1] + plane[p + 2] * x[k + 2] - plane[p + 3] - gapAtRest[i];
        }
    }

    private static int pieces(int points) {
        return (points + POINTS_A_PIECE - 1) / POINTS_A_PIECE;
    }

    @Override
    public int pointCount() {
        return share.length;
    }

    @Override
    public void at(double time, double[] position, double[] velocity) {
        wall.prepare(time);
        open();
        since = time - lastTime;
        system.workers().run(pieces(share.length), carryTask);
        lastTime = time;
        System.arraycopy(anchor, 0, position, 0, anchor.length);
        System.arraycopy(speed, 0, velocity, 0, speed.length);
    }

    private void carry(int piece) {
        double[] x = system.positions();
        boolean anew = !(since > 0 && since < LONGEST_S);
        int end = Math.min(share.length, (piece + 1) * POINTS_A_PIECE);
        for (int i = piece * POINTS_A_PIECE; i < end; i++) {
            double along = share[i] > 0 ? share[i] * slid(i) : 0;
            int last = start[i + 1] - 1;
            int point = Math.min(start[i] + (int) along, Math.max(start[i], last - 1));
            double t = last == start[i] ? 0 : Math.min(1, start[i] + along - point);
            int next = t > 0 ? point + 1 : point;
            for (int axis = 0; axis < 3; axis++) {
                int c = 3 * i + axis;
                double place = (1 - t) * mean(point, axis, x) + t * mean(next, axis, x);
                double up = (1 - t) * normal[3 * point + axis] + t * normal[3 * next + axis];
                double to = place + height[i] * up + aside[c];
                anchor[c] = anew ? to : anchor[c] + since * speed[c];
                speed[c] = anew ? 0 : (to - target[c]) / since + (to - anchor[c]) / CATCH_UP_S;
                target[c] = to;
            }
        }
    }

    /** How much of a track has opened, in points. */
    private double slid(int track) {
        double sum = 0;
        for (int p = apposed[track]; p < start[track + 1]; p++) {
            double u = Math.max(0, Math.min(1, at(p, opening) / OPEN_MM));
            sum += u * u * (3 - 2 * u);
        }
        return sum;
    }

    /** Coordinate of a point of a track as the sheet stands. */
    private double mean(int point, int axis, double[] of) {
        return weight[3 * point] * of[watched[corner[3 * point]] + axis]
                + weight[3 * point + 1] * of[watched[corner[3 * point + 1]] + axis]
                + weight[3 * point + 2] * of[watched[corner[3 * point + 2]] + axis];
    }

    /** Nodes of the lungs that lie on the base, the diaphragm's node nearest to each, and the stiffness that holds each to its place there. */
    record Ties(List<Integer> nodes, List<Integer> nearest, List<Double> stiffness) {
        int[] node() {
            return nodes.stream().mapToInt(Integer::intValue).toArray();
        }

        int[] nearestNode() {
            return nearest.stream().mapToInt(Integer::intValue).toArray();
        }

        double[] stiffnesses() {
            return stiffness.stream().mapToDouble(Double::doubleValue).toArray();
        }
    }
}
