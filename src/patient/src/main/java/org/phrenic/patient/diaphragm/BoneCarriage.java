package org.phrenic.patient.diaphragm;

import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.force.FallOff;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;

/**
 * Carries points along with ribs and sternum that turn back on their helical axes. A point near bone goes with the
 * bones about it ({@link SkinningWeights}). Half way between sternum and spine, or between both sides, the nearest bone
 * changes from one to the other within millimetres; the displacement u of a surface there is harmonic:
 *
 * <pre>
 * u = n u_bone + (1 - n) (mean of u over the neighbouring vertices)
 * </pre>
 *
 * where n falls from 1 to 0 between {@value #NEAR_MM} and {@value #FAR_MM} mm from the nearest bone.
 */
final class BoneCarriage {
    private static final double NEAR_MM = 10;
    private static final double FAR_MM = 25;
    private static final int ROUNDS = 200;
    /** The pose is the same at any time. */
    private static final double TIME_S = 0;

    private final RibCagePose pose;
    private final SkinningWeights skinning;

    /** @param share share of a full inspiration by which ribs turn back */
    BoneCarriage(Thorax completed, double share) {
        RibCage cage = RibCage.of(completed, RibAxisTable.preset(RibAxisTable.WILSON_CT), true);
        pose = new RibCagePose(cage, (time, amplitude) -> amplitude[0] = -share);
        pose.update(TIME_S);
        skinning = SkinningWeights.of(completed, cage);
    }

    RibCage cage() {
        return pose.cage();
    }

    /** A point carried by one bone. */
    double[] carried(int body, double[] point) {
        double[] out = new double[3];
        HelicalBody.transformPoints(pose.pose(body), point, 0, out, 0, 1);
        return out;
    }

    /** Points carried by the bones near them. */
    double[] carried(double[] p) {
        return carried(p, skinning.weightsAt(p));
    }

    private double[] carried(double[] p, SkinningWeights.Weights weights) {
        double[] out = new double[p.length];
        new LinearBlendSkinning(pose, p, weights, Workers.of(1)).at(TIME_S, out, new double[p.length]);
        return out;
    }

    /** Displacements of the vertices of a surface, harmonic far from bone, mm. */
    double[] displacement(TriangleMesh mesh) {
        double[] p = mesh.positions();
        SkinningWeights.Weights weights = skinning.weightsAt(p);
        double[] ofBone = carried(p, weights);
        double[] near = new double[p.length / 3];
        for (int v = 0; v < near.length; v++) {
            near[v] = FallOff.at(Math.max(0, weights.distance()[v] - NEAR_MM), FAR_MM - NEAR_MM);
            for (int i = 3 * v; i < 3 * v + 3; i++) {
                ofBone[i] -= p[i];
            }
        }
        double[] u = ofBone.clone();
        for (int round = 0; round < ROUNDS; round++) {
            u = relaxed(mesh.triangles(), near, ofBone, u);
        }
        return u;
    }

    private static double[] relaxed(int[] corners, double[] near, double[] ofBone, double[] u) {
        double[] sum = new double[u.length];
        int[] neighbours = new int[near.length];
        for (int corner = 0; corner < corners.length; corner++) {
            int v = corners[corner];
            int first = corners[corner - corner % 3 + (corner + 1) % 3];
            int second = corners[corner - corner % 3 + (corner + 2) % 3];
            neighbours[v] += 2;
            for (int axis = 0; axis < 3; axis++) {
                sum[3 * v + axis] += u[3 * first + axis] + u[3 * second + axis];
            }
        }
        double[] next = u.clone();
        for (int i = 0; i < u.length; i++) {
            int v = i / 3;
            if (neighbours[v] > 0) {
                next[i] = near[v] * ofBone[i] + (1 - near[v]) * sum[i] / neighbours[v];
            }
        }
        return next;
    }
}
