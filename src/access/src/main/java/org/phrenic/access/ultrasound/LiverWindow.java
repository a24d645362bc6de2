package org.phrenic.access.ultrasound;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.phrenic.access.Midline;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/** Usual places of a probe to look at the liver, found on any body from its bones and its liver at end-expiration. */
public enum LiverWindow {
    /** On the right side in the mid-axillary line at the height of the liver's middle, between two ribs. */
    RIGHT_INTERCOSTAL,
    /** In front, between the right edge of the liver and the midline, 20 mm below the costal margin. */
    RIGHT_SUBCOSTAL,
    /** In front, in the midline, 20 mm below the sternum. */
    SUBXIPHOID;

    private static final double BELOW_MM = 20;
    private static final double SEARCH_MM = 25;
    private static final double STRIP_MM = 15;
    private static final double FAR_MM = 1000;

    /** Name on the command line, such as {@code right-intercostal}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The window with a label, or empty. */
    public static Optional<LiverWindow> of(String label) {
        return java.util.Arrays.stream(values())
                .filter(w -> w.label().equals(label))
                .findFirst();
    }

    /**
     * The place on the skin at end-expiration, LPS, mm.
     *
     * @throws BadInputException if the body lacks what the place is found from
     */
    public double[] placeOn(List<Surface> surfaces) {
        Surface skin = ScannedSkin.of(surfaces);
        double[] liver = bounds(surfaces, "liver", s -> s.kind() == StructureKind.LIVER);
        double[] middle = {0.5 * (liver[0] + liver[3]), 0.5 * (liver[1] + liver[4]), 0.5 * (liver[2] + liver[5])};
        TriangleTree tree = new TriangleTree(skin.rest());
        return switch (this) {
            case RIGHT_INTERCOSTAL -> betweenRibs(surfaces, tree, middle);
            case RIGHT_SUBCOSTAL -> {
                double x = 0.5 * (liver[0] + midline(surfaces));
                yield front(tree, x, middle[1], lowestNear(surfaces, x) - BELOW_MM);
            }
            case SUBXIPHOID -> {
                double[] sternum = bounds(surfaces, "sternum", s -> s.kind() == StructureKind.STERNUM);
                yield front(tree, midline(surfaces), middle[1], sternum[2] - BELOW_MM);
            }
        };
    }

    private static double midline(List<Surface> surfaces) {
        return Midline.x(surfaces, s -> s, s -> s.rest().bounds());
    }

    private static double[] bounds(List<Surface> surfaces, String what, Predicate<Surface> wanted) {
        List<Surface> all = surfaces.stream().filter(wanted).toList();
        if (all.isEmpty()) {
            throw new BadInputException("the body: found no " + what + ", expected one to find this place from");
        }
        return Surface.bounds(all);
    }

    /** The height at the side, near that of the middle of the liver, that is farthest from all ribs. */
    private static double[] betweenRibs(List<Surface> surfaces, TriangleTree skin, double[] middle) {
        List<TriangleTree> ribs = surfaces.stream()
                .filter(s -> s.kind() == StructureKind.RIB && s.side() == Side.RIGHT)
                .map(s -> new TriangleTree(s.rest()))
                .toList();
        double[] best = new double[0];
        double widest = -1;
        for (double dz = -SEARCH_MM; dz <= SEARCH_MM; dz++) {
            double[] at = hit(skin, Vectors.of(middle[0], middle[1], middle[2] + dz), -1, 0);
            double gap = FAR_MM;
            for (TriangleTree rib : ribs) {
                TriangleTree.Hit hit = new TriangleTree.Hit();
                rib.closest(at[0], at[1], at[2], hit);
                gap = Math.min(gap, Math.sqrt(hit.distanceSquared));
            }
            if (gap > widest) {
                widest = gap;
                best = at;
            }
        }
        return best;
    }

    /** Lowest height of ribs and costal cartilages in front near a sagittal plane. */
    private static double lowestNear(List<Surface> surfaces, double x) {
        double lowest = Double.POSITIVE_INFINITY;
        double[] cage = bounds(surfaces, "rib", s -> s.kind() == StructureKind.RIB);
        double front = 0.5 * (cage[1] + cage[4]);
        for (Surface s : surfaces) {
            if (s.kind() == StructureKind.RIB || s.kind() == StructureKind.COSTAL_CARTILAGE) {
                for (int v = 0; v < s.rest().vertexCount(); v++) {
                    boolean near =
                            Math.abs(s.rest().x(v) - x) < STRIP_MM && s.rest().y(v) < front;
                    lowest = near ? Math.min(lowest, s.rest().z(v)) : lowest;
                }
            }
        }
        if (Double.isInfinite(lowest)) {
            throw new BadInputException("the body: found no costal margin on the right, expected ribs in front");
        }
        return lowest;
    }

    private static double[] front(TriangleTree skin, double x, double y, double z) {
        return hit(skin, Vectors.of(x, y, z), 0, -1);
    }

    /** Where a ray leaves the skin for the last time. */
    private static double[] hit(TriangleTree skin, double[] from, double dx, double dy) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] far = Vectors.addScaled(from, Vectors.of(dx, dy, 0), FAR_MM);
        if (!skin.nearestAlongRay(far[0], far[1], far[2], -dx, -dy, 0, hit)) {
            throw new BadInputException(
                    "the body: found no skin beside the liver, expected a trunk that reaches there");
        }
        return Vectors.addScaled(far, Vectors.of(-dx, -dy, 0), hit.rayParameter);
    }
}
