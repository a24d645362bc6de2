package org.phrenic.access;

import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.query.TriangleTree;

/** A place on the skin, which moves with it: three corners and their weights. */
public final class SkinPoint {
    /** A place given so near to the skin counts as on it, mm. */
    static final double NEAR_MM = 5;

    private final MovingStructure skin;
    private final int triangle;
    private final double[] weights;

    /**
     * The point of the skin that is nearest to a place now.
     *
     * @throws BadInputException with one sentence, if the place is farther than {@value #NEAR_MM} mm from the skin
     */
    public static SkinPoint current(MovingStructure skin, double[] place) {
        return new SkinPoint(skin, skin.tree(), skin.toLocal(place), place);
    }

    /** As {@link #current(MovingStructure, double[])}, of a place on the skin as it is at end-expiration. */
    public static SkinPoint atRest(MovingStructure skin, double[] place) {
        return new SkinPoint(skin, new TriangleTree(skin.surface().rest()), place, place);
    }

    private SkinPoint(MovingStructure skin, TriangleTree tree, double[] own, double[] place) {
        this.skin = skin;
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(own[0], own[1], own[2], hit);
        double away = Math.sqrt(hit.distanceSquared);
        if (away > NEAR_MM) {
            boolean inside = tree.isInside(own[0], own[1], own[2]);
            throw new BadInputException(String.format(
                    Locale.ROOT,
                    "entry: found (%.1f, %.1f, %.1f), %.1f mm %s, expected a place on the skin",
                    place[0],
                    place[1],
                    place[2],
                    away,
                    inside ? "inside the body" : "off the skin"));
        }
        triangle = hit.triangle;
        weights = new double[] {hit.weightA, hit.weightB, hit.weightC};
    }

    /** Where it is now. */
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
