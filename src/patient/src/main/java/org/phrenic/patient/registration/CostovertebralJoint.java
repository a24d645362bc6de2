package org.phrenic.patient.registration;

import java.util.Optional;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The joint of a rib's head with the spine: ribs 2 to 9 between the bodies of two vertebrae, as near to one as to the
 * other; rib 10 mostly at its own; ribs 1, 11 and 12 at their own alone.
 */
final class CostovertebralJoint {
    /** Last rib that lies between two vertebrae. */
    private static final int LAST_SHARED = 10;
    /** Distance of the middle of a head from the bone that it lies on, mm: half the height of a head. */
    private static final double SHARED_MM = 4.5;

    private static final double SINGLE_MM = 3.5;
    /** Weight of the place from the rib and the template, relative to each vertebra. */
    private static final double HOLD = 0.75;
    /** Weight of the vertebra above for rib 10, which often has no facet there. */
    private static final double TENTH_ABOVE = 0.5;

    private static final int ROUNDS = 40;

    private final TriangleTree own;
    private final Optional<TriangleTree> above;
    private final double aboveWeight;

    /** @param above the vertebra above; counts for ribs 2 to 10 */
    CostovertebralJoint(int level, TriangleMesh own, Optional<TriangleMesh> above) {
        this.own = new TriangleTree(own);
        this.above = above.filter(m -> level > 1 && level <= LAST_SHARED).map(TriangleTree::new);
        aboveWeight = level == LAST_SHARED ? TENTH_ABOVE : 1;
    }

    /** The place of the head nearest to a first estimate. */
    double[] settle(double[] estimate) {
        double[] p = estimate.clone();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int round = 0; round < ROUNDS; round++) {
            double[] sum = {HOLD * estimate[0], HOLD * estimate[1], HOLD * estimate[2]};
            add(own, 1, p, above.isPresent() ? SHARED_MM : SINGLE_MM, sum, hit);
            above.ifPresent(tree -> add(tree, aboveWeight, p, SHARED_MM, sum, hit));
            double total = HOLD + 1 + (above.isPresent() ? aboveWeight : 0);
            for (int k = 0; k < 3; k++) {
                p[k] = (p[k] + sum[k] / total) / 2;
            }
        }
        return p;
    }

    /** Adds the point at a distance from the bone on the way from its nearest point to p. */
    private static void add(
            TriangleTree bone, double weight, double[] p, double distanceMm, double[] sum, TriangleTree.Hit hit) {
        bone.closest(p[0], p[1], p[2], hit);
        double distance = Math.max(1e-6, Math.sqrt(hit.distanceSquared));
        double factor = (bone.isInside(p[0], p[1], p[2]) ? -1 : 1) * distanceMm / distance;
        sum[0] += weight * (hit.x + factor * (p[0] - hit.x));
        sum[1] += weight * (hit.y + factor * (p[1] - hit.y));
        sum[2] += weight * (hit.z + factor * (p[2] - hit.z));
    }
}
