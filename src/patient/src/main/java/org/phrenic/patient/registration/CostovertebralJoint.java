package org.phrenic.patient.registration;

import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The joint of a rib's head with the spine. Heads of ribs 2 to 9 lie beside the disc between two vertebrae, that of rib
 * 10 beside the upper edge of its own, those of ribs 1, 11 and 12 beside the body of their own; all of them in the
 * posterior third of the body, at the side of the bone.
 */
final class CostovertebralJoint {
    /** Distance of a head behind the middle of the body, as a fraction of half its depth. */
    private static final double BACK = 0.65;
    /** Height of ribs 2 to 9 above the upper end plate, as a fraction of the disc: the lower facet is the larger. */
    private static final double ON_DISC = 0.3;
    /** Depth of the heads of ribs 1, 11 and 12 below the upper end plate, as fractions of the height of the body. */
    private static final double FIRST = 0.15;

    private static final double ELEVENTH = 0.2;
    private static final double TWELFTH = 0.35;
    /** Distance of the middle of a head from the side of the bone, mm. */
    private static final double BESIDE_MM = 1.5;
    /** Distance from the end plates at which the side of a body is measured, mm. */
    private static final double RIM_MM = 2;
    /** Start of the rays that look for the side of the bone, mm from the middle. */
    private static final double REACH_MM = 45;

    private final int level;
    private final int sign;
    private final VertebralBody own;
    private final TriangleTree ownBone;
    private final Optional<VertebralBody> above;
    private final Optional<TriangleTree> boneAbove;

    /** A vertebra: its surface and its body. */
    record Vertebra(TriangleTree bone, VertebralBody body) {}

    /** @param above the vertebra above; counts for ribs 2 to 9 */
    CostovertebralJoint(int level, Side side, Vertebra own, Optional<Vertebra> above) {
        this.level = level;
        this.sign = side.sign();
        this.own = own.body();
        ownBone = own.bone();
        Optional<Vertebra> joined = above.filter(v -> level > 1 && level < 10);
        this.above = joined.map(Vertebra::body);
        boneAbove = joined.map(Vertebra::bone);
    }

    /** Place of the middle of the head. */
    double[] place() {
        double up = own.halfHeightMm()
                + 2
                        * own.halfHeightMm()
                        * switch (level) {
                            case 1 -> -FIRST;
                            case 11 -> -ELEVENTH;
                            case 12 -> -TWELFTH;
                            default -> 0;
                        };
        return beside(own.point(0, BACK * own.halfDepthMm(), up + ON_DISC * discMm()));
    }

    /** Height of the disc at the joint; 0 for a rib that has its own vertebra alone. */
    private double discMm() {
        return above.map(v -> Math.max(
                        0, own.local(v.point(0, BACK * v.halfDepthMm(), -v.halfHeightMm()))[2] - own.halfHeightMm()))
                .orElse(0.0);
    }

    /** Moves a point from side to side until it lies beside the bone. */
    double[] beside(double[] point) {
        double[] at = own.local(point);
        double wall = wall(own, ownBone, at[1], Math.min(at[2], own.halfHeightMm() - RIM_MM));
        if (above.isPresent()) {
            double[] there = above.get().local(point);
            double other = wall(
                    above.get(),
                    boneAbove.orElseThrow(),
                    there[1],
                    Math.max(there[2], RIM_MM - above.get().halfHeightMm()));
            double disc = Math.max(1e-6, discMm());
            double share = Math.max(0, Math.min(1, (at[2] - own.halfHeightMm()) / disc));
            wall += share * (other - wall);
        }
        return own.point(sign * (wall + BESIDE_MM), at[1], at[2]);
    }

    /** Distance of the side of the bone from the middle of a body, mm. */
    private double wall(VertebralBody body, TriangleTree bone, double back, double up) {
        double[] from = body.point(sign * REACH_MM, back, up);
        double[] d = body.left();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        boolean met = bone.nearestAlongRay(from[0], from[1], from[2], -sign * d[0], -sign * d[1], -sign * d[2], hit);
        double wall = met ? REACH_MM - hit.rayParameter : body.halfWidthMm();
        return Math.max(0.6 * body.halfWidthMm(), Math.min(1.5 * body.halfWidthMm(), wall));
    }
}
