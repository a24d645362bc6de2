package org.phrenic.anatomy.cage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Sample points on ribs, sternum, vertebrae and costal cartilages, with body weights. Points of a bone have the weight
 * of its body. Weights of a cartilage blend from the rib at its lateral end to the sternum (for cartilages 8 to 10, and
 * without a sternum, the cartilage above) at its medial end. With neither, it has the weight of its rib.
 */
final class BoneSamples {
    /** Samples per structure; on a rib they are a few millimetres apart. */
    private static final int SAMPLES = 240;

    private final int bodies;
    /** Three coordinates each, mm. */
    final List<double[]> points = new ArrayList<>();
    /** Weight of every body for each point; the weights of a point sum to 1. */
    final List<double[]> weights = new ArrayList<>();

    private BoneSamples(int bodies) {
        this.bodies = bodies;
    }

    /** Samples the bones of a thorax. */
    static BoneSamples of(Thorax thorax, RibCage cage) {
        BoneSamples all = new BoneSamples(cage.bodies().size());
        for (Structure s : thorax.structures()) {
            switch (s.kind()) {
                case RIB -> all.addRigid(s.mesh(), cage.rib(s.level(), s.side()));
                case STERNUM -> all.addRigid(s.mesh(), cage.sternum());
                case VERTEBRA -> all.addRigid(s.mesh(), RibCage.TRUNK);
                default -> {
                    // Other bones, discs and soft tissue have no samples.
                }
            }
        }
        TriangleTree sternum = sternumTree(thorax);
        for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
            double[][] aboveWeights = null;
            double[] abovePoints = null;
            for (int level = 1; level <= 10; level++) {
                Optional<Structure> cartilage = thorax.find(StructureKind.COSTAL_CARTILAGE, level, side);
                if (cartilage.isEmpty()) {
                    continue;
                }
                double[] p = subsample(cartilage.get().mesh());
                int rib = cage.rib(level, side);
                double[][] w = new double[p.length / 3][];
                TriangleTree medial = level <= 7 || aboveWeights == null ? sternum : null;
                for (int i = 0; i < w.length; i++) {
                    w[i] = cartilageBlendWeights(cage, rib, p, 3 * i, medial, aboveWeights, abovePoints);
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
        List<TriangleMesh> parts = thorax.structuresOf(StructureKind.STERNUM).stream()
                .map(Structure::mesh)
                .toList();
        return parts.isEmpty() ? null : new TriangleTree(MeshMerge.merge(parts));
    }

    private static double[] cartilageBlendWeights(
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
        if (sternum == null && aboveWeights == null) {
            w[rib] = 1;
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
        double[] p = subsample(mesh);
        double[] w = new double[bodies];
        w[body] = 1;
        for (int i = 0; i < p.length; i += 3) {
            points.add(Arrays.copyOfRange(p, i, i + 3));
            weights.add(w);
        }
    }

    private static double[] subsample(TriangleMesh mesh) {
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
}
