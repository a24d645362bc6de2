package org.phrenic.patient.registration;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Places a vertebra of the template on a vertebra of the scan: a similarity by trimmed iterative closest points in both
 * directions, started from matched centres.
 */
final class VertebraFit {
    private static final int POINTS = 250;
    private static final int ROUNDS = 20;
    private static final double INLIER_FRACTION = 0.8;
    /** Limits of the change against the start; beyond them a vertebra is in pieces, merged or mislabelled. */
    private static final double MAX_TURN_DEG = 25;

    private static final double MIN_SCALE = 0.6;
    private static final double MAX_SCALE = 1.6;

    private VertebraFit() {}

    /**
     * Fits the vertebra.
     *
     * @param placed vertebra of the template as placed so far
     * @return the placed vertebra after the fit, vertex by vertex; only shifted where a limit is passed
     */
    static double[] fit(TriangleMesh placed, TriangleMesh scan) {
        double[] start = placed.positions().clone();
        double[] from = RoughAlignment.centroid(placed);
        double[] to = RoughAlignment.centroid(scan);
        for (int i = 0; i < start.length; i++) {
            start[i] += to[i % 3] - from[i % 3];
        }
        TriangleTree scanTree = new TriangleTree(scan);
        TriangleTree tree = new TriangleTree(placed.withPositions(start.clone()));
        AffineTransform3D whole = AffineTransform3D.similarity(start, start);
        double[] now = start;
        for (int round = 0; round < ROUNDS; round++) {
            double[][] pairs = trimmed(placed, now, scan, tree, scanTree);
            AffineTransform3D step = AffineTransform3D.similarity(pairs[0], pairs[1]);
            now = now.clone();
            step.apply(now);
            tree.refit(now);
            whole = AffineTransform3D.similarity(start, now);
            if (whole.scale() < MIN_SCALE || whole.scale() > MAX_SCALE || whole.turnDeg() > MAX_TURN_DEG) {
                return start;
            }
        }
        return now;
    }

    /** Nearest points in both directions; the farthest are left out. */
    private static double[][] trimmed(
            TriangleMesh template, double[] now, TriangleMesh scan, TriangleTree tree, TriangleTree scanTree) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int n = Math.min(POINTS, template.vertexCount());
        int m = Math.min(POINTS, scan.vertexCount());
        double[] from = new double[3 * (n + m)];
        double[] to = new double[from.length];
        double[] squared = new double[n + m];
        for (int i = 0; i < n + m; i++) {
            boolean ofTemplate = i < n;
            double[] source = ofTemplate ? now : scan.positions();
            int v = ofTemplate
                    ? (int) ((long) i * template.vertexCount() / n)
                    : (int) ((long) (i - n) * scan.vertexCount() / m);
            (ofTemplate ? scanTree : tree).closest(source[3 * v], source[3 * v + 1], source[3 * v + 2], hit);
            System.arraycopy(source, 3 * v, ofTemplate ? from : to, 3 * i, 3);
            double[] other = ofTemplate ? to : from;
            other[3 * i] = hit.x;
            other[3 * i + 1] = hit.y;
            other[3 * i + 2] = hit.z;
            squared[i] = hit.distanceSquared;
        }
        double[] sorted = squared.clone();
        Arrays.sort(sorted);
        double limit = sorted[(int) (INLIER_FRACTION * (sorted.length - 1))];
        int kept = 0;
        for (int i = 0; i < squared.length; i++) {
            if (squared[i] <= limit) {
                System.arraycopy(from, 3 * i, from, 3 * kept, 3);
                System.arraycopy(to, 3 * i, to, 3 * kept, 3);
                kept++;
            }
        }
        return new double[][] {Arrays.copyOf(from, 3 * kept), Arrays.copyOf(to, 3 * kept)};
    }
}
