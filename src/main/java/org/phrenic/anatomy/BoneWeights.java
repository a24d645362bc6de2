package org.phrenic.anatomy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.engine.force.FallOff;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.geometry.TriangleTree;

/**
 * Which bones carry a point, and by how much. Samples of all bones know their body; samples of a costal cartilage blend from the rib at its lateral end to the sternum (or, for cartilages 8
 * to 10, the cartilage above) at its medial end. A point takes the mean of the samples around it, which fades smoothly with distance, so that a row of points along the costal margin moves as one smooth band.
 */
public final class BoneWeights {
    /** Bodies that may carry one point. */
    public static final int MOST_BODIES = 4;

    /** Samples a structure: a few millimetres apart on a rib. */
    private static final int SAMPLES = 240;
    /** How much farther than the nearest sample a sample may be and still count, mm: half the space between two ribs. */
    private static final double REACH_MM = 14;

    /**
     * What carries some points.
     *
     * @param body {@link #MOST_BODIES} entries a point
     * @param weight of each entry, 0 for one not used
     * @param distance of each point from the nearest bone, mm
     */
    public record Blend(int[] body, double[] weight, double[] distance) {}

    private final int bodies;
    private final List<double[]> points = new ArrayList<>();
    private final List<double[]> weights = new ArrayList<>();

    private BoneWeights(int bodies) {
        this.bodies = bodies;
    }

    /** Samples of the bones of a thorax. */
    public static BoneWeights of(Thorax thorax, RibCage cage) {
        BoneWeights all = new BoneWeights(cage.bodies().size());
        for (Structure s : thorax.structures()) {
            switch (s.kind()) {
                case RIB -> all.addRigid(s.mesh(), cage.rib(s.level(), s.side()));
                case STERNUM -> all.addRigid(s.mesh(), cage.sternum());
                case VERTEBRA -> all.addRigid(s.mesh(), RibCage.TRUNK);
                default -> {
                    // Soft parts carry nothing.
                }
            }
        }
        for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
            double[][] aboveWeights = null;
            double[] abovePoints = null;
            for (int level = 1; level <= 10; level++) {
                Optional<Structure> cartilage = thorax.find(StructureKind.COSTAL_CARTILAGE, level, side);
                if (cartilage.isEmpty()) {
                    continue;
                }
                double[] p = sampled(cartilage.get().mesh());
                int rib = cage.rib(level, side);
                double[][] w = new double[p.length / 3][];
                TriangleTree medial = level <= 7 || aboveWeights == null ? sternumTree(thorax) : null;
                for (int i = 0; i < w.length; i++) {
                    w[i] = cartilageWeights(cage, rib, p, 3 * i, medial, aboveWeights, abovePoints);
                    all.points.add(Arrays.copyOfRange(p, 3 * i, 3 * i + 3));
                    all.weights.add(w[i]);
                }
                aboveWeights = w;
                abovePoints = p;
            }
        }
        return all;
    }

    private static TriangleTree sternumTree(Thorax thorax) {
        List<TriangleMesh> parts =
                thorax.all(StructureKind.STERNUM).stream().map(Structure::mesh).toList();
        return parts.isEmpty() ? null : new TriangleTree(Meshes.merge(parts));
    }

    private static double[] cartilageWeights(
            RibCage cage,
            int rib,
            double[] p,
            int at,
            TriangleTree sternum,
            double[][] aboveWeights,
            double[] abovePoints) {
        double[] w = new double[cage.bodies().size()];
        if (rib < 0) {
            w[cage.sternum()] = 1;
            return w;
        }
        double[] end = cage.bodies().get(rib).ends().orElseThrow().anterior();
        double toRib = distance(p, at, end, 0);
        double toMedial;
        double[] medial = new double[w.length];
        if (sternum != null) {
            TriangleTree.Hit hit = new TriangleTree.Hit();
            sternum.closest(p[at], p[at + 1], p[at + 2], hit);
            toMedial = Math.sqrt(hit.distanceSquared);
            medial[cage.sternum()] = 1;
        } else {
            int nearest = 0;
            for (int j = 1; j < aboveWeights.length; j++) {
                if (distance(p, at, abovePoints, 3 * j) < distance(p, at, abovePoints, 3 * nearest)) {
                    nearest = j;
                }
            }
            toMedial = distance(p, at, abovePoints, 3 * nearest);
            medial = aboveWeights[nearest];
        }
        double f = toRib / Math.max(1e-9, toRib + toMedial);
        f = f * f * (3 - 2 * f);
        for (int b = 0; b < w.length; b++) {
            w[b] = f * medial[b];
        }
        w[rib] += 1 - f;
        return w;
    }

    private void addRigid(TriangleMesh mesh, int body) {
        if (body < 0) {
            return;
        }
        double[] p = sampled(mesh);
        double[] w = new double[bodies];
        w[body] = 1;
        for (int i = 0; i < p.length; i += 3) {
            points.add(Arrays.copyOfRange(p, i, i + 3));
            weights.add(w);
        }
    }

    private static double[] sampled(TriangleMesh mesh) {
        int n = mesh.vertexCount();
        int count = Math.min(SAMPLES, n);
        double[] out = new double[3 * count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(mesh.positions(), 3 * (int) ((long) i * n / count), out, 3 * i, 3);
        }
        return out;
    }

    private static double distance(double[] p, int i, double[] q, int j) {
        double x = p[i] - q[j];
        double y = p[i + 1] - q[j + 1];
        double z = p[i + 2] - q[j + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Weights of points, mm. */
    public Blend at(double[] where) {
        int n = where.length / 3;
        int[] body = new int[n * MOST_BODIES];
        double[] weight = new double[n * MOST_BODIES];
        double[] distance = new double[n];
        int count = points.size();
        double[] d = new double[count];
        for (int i = 0; i < n; i++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < count; j++) {
                d[j] = distance(where, 3 * i, points.get(j), 0);
                nearest = Math.min(nearest, d[j]);
            }
            distance[i] = nearest;
            double[] sum = new double[bodies];
            for (int j = 0; j < count; j++) {
                if (d[j] < nearest + REACH_MM) {
                    double f = FallOff.at(d[j], nearest + REACH_MM);
                    double[] w = weights.get(j);
                    for (int b = 0; b < bodies; b++) {
                        sum[b] += f * w[b];
                    }
                }
            }
            keepLargest(sum, body, weight, i * MOST_BODIES);
        }
        return new Blend(body, weight, distance);
    }

    private static void keepLargest(double[] sum, int[] body, double[] weight, int at) {
        double total = 0;
        for (int k = 0; k < MOST_BODIES; k++) {
            int best = 0;
            for (int b = 1; b < sum.length; b++) {
                if (sum[b] > sum[best]) {
                    best = b;
                }
            }
            body[at + k] = best;
            weight[at + k] = Math.max(0, sum[best]);
            total += weight[at + k];
            sum[best] = Double.NEGATIVE_INFINITY;
        }
        for (int k = 0; k < MOST_BODIES; k++) {
            weight[at + k] = total > 0 ? weight[at + k] / total : k == 0 ? 1 : 0;
        }
    }
}
