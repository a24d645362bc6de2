package org.phrenic.access;

import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.query.TriangleTree;

/** A point that moves with the skin, stored as a triangle and barycentric weights. */
public final class SkinPoint {
    /** Maximum distance between the given point and the skin, mm. */
    static final double TOLERANCE_MM = 5;

    private final MovingStructure skin;
    private final int triangle;
    private final double[] weights;

    /**
     * Returns the skin point nearest to a position in the current frame.
     *
     * @throws BadInputException if the position is more than {@value #TOLERANCE_MM} mm from the skin
     */
    public static SkinPoint current(MovingStructure skin, double[] place) {
        return new SkinPoint(skin, skin.tree(), skin.toLocal(place), place);
    }

    /** Like {@link #current(MovingStructure, double[])}, but for a position at end-expiration. */
    public static SkinPoint atRest(MovingStructure skin, double[] place) {
        return new SkinPoint(skin, new TriangleTree(skin.surface().rest()), place, place);
    }

    private SkinPoint(MovingStructure skin, TriangleTree tree, double[] local, double[] place) {
        this.skin = skin;
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(local[0], local[1], local[2], hit);
        double distance = Math.sqrt(hit.distanceSquared);
        if (distance > TOLERANCE_MM) {
            String side = tree.isInside(local[0], local[1], local[2]) ? "inside the body" : "off the skin";
            throw new BadInputException(Numbers.format(
                    "entry: found (%.1f, %.1f, %.1f), %.1f mm %s, expected a place on the skin",
                    place[0], place[1], place[2], distance, side));
        }
        triangle = hit.triangle;
        weights = new double[] {hit.weightA, hit.weightB, hit.weightC};
    }

    /** The corner of its triangle that it is nearest to, in weights: a vertex of the skin. */
    public int nearestVertex() {
        int most = weights[1] > weights[0] ? 1 : 0;
        most = weights[2] > weights[most] ? 2 : most;
        return skin.surface().rest().triangles()[3 * triangle + most];
    }

    /** Position in the current frame, LPS, mm. */
    public double[] current() {
        int[] t = skin.surface().rest().triangles();
        double[] p = skin.positions();
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++) {
                at[axis] += weights[k] * p[3 * t[3 * triangle + k] + axis];
            }
        }
        return skin.toWorld(at);
    }
}
