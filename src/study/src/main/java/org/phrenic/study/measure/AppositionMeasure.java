package org.phrenic.study.measure;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;

/**
 * Zone of apposition: the part of the diaphragm's thoracic face that touches the rib cage below the lung. A triangle
 * belongs to it if all of the following hold:
 *
 * <ul>
 *   <li>its centroid is within 15 mm of a rib or cartilage (half of an intercostal space and the muscle in it);
 *   <li>its centroid is more than 5 mm from every lung;
 *   <li>its normal is within 60 degrees of horizontal and points away from the body's midline.
 * </ul>
 *
 * <p>The costal part of the lungs' surface follows the same rule without the lung distance. The inner area of the rib
 * cage is the sum of both. The lateral height is the zone's area within 20 degrees of lateral, divided by the width of
 * that sector.
 */
final class AppositionMeasure implements SceneMeasure {
    static final List<String> NAMES =
            List.of("apposition_area_cm2", "apposition_share_percent", "apposition_lateral_mm");

    private static final double MAX_BONE_DISTANCE_MM = 15;
    private static final double MIN_LUNG_DISTANCE_MM = 5;
    private static final double MIN_HORIZONTAL_COMPONENT = 0.5;
    /** Cosine of the largest angle from the lateral direction. */
    private static final double MIN_LATERAL_COSINE = 0.94;

    private final int sheet;
    private final int[] lungs;
    private final int[] bones;
    private final boolean[] thoracic;
    private final double middleX;
    private final double middleY;
    private final TriangleTree[] boneTrees;
    private final TriangleTree[] lungTrees;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    AppositionMeasure(SceneGeometry view) {
        sheet = view.diaphragm();
        lungs = view.indicesOf(StructureKind.LUNG);
        bones = view.indicesOf(s -> s.kind() == StructureKind.RIB || s.kind() == StructureKind.COSTAL_CARTILAGE);
        thoracic = view.thoracicTriangles();
        double[] box = view.surface(sheet).rest().bounds();
        middleX = 0.5 * (box[0] + box[3]);
        middleY = 0.5 * (box[1] + box[4]);
        boneTrees = trees(view, bones);
        lungTrees = trees(view, lungs);
    }

    private static TriangleTree[] trees(SceneGeometry view, int[] surfaces) {
        return IntStream.of(surfaces)
                .mapToObj(i -> new TriangleTree(view.surface(i).rest()))
                .toArray(TriangleTree[]::new);
    }

    private static void refit(SceneGeometry view, int[] surfaces, TriangleTree[] trees) {
        for (int i = 0; i < surfaces.length; i++) {
            trees[i].refit(view.positions(surfaces[i]));
        }
    }

    /** Total area, area in the lateral sector, and lateral area times distance from the middle. */
    private static final class Sum {
        double area;
        double lateral;
        double moment;
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        if (bones.length == 0) {
            return;
        }
        refit(view, bones, boneTrees);
        refit(view, lungs, lungTrees);
        Sum apposed = new Sum();
        add(view.surface(sheet).rest().triangles(), view.positions(sheet), thoracic, apposed);
        Sum costal = new Sum();
        for (int lung : lungs) {
            add(view.surface(lung).rest().triangles(), view.positions(lung), null, costal);
        }
        values.put("apposition_area_cm2", apposed.area / 100);
        if (costal.area > 0) {
            values.put("apposition_share_percent", 100 * apposed.area / (apposed.area + costal.area));
        }
        double width = 4 * StrictMath.acos(MIN_LATERAL_COSINE) * apposed.moment / apposed.lateral;
        values.put("apposition_lateral_mm", apposed.lateral == 0 ? 0 : apposed.lateral / width);
    }

    private void add(int[] t, double[] p, boolean[] which, Sum sum) {
        double[] normal = new double[3];
        for (int i = 0; i < t.length; i += 3) {
            if (which != null && !which[i / 3]) {
                continue;
            }
            int a = 3 * t[i];
            int b = 3 * t[i + 1];
            int c = 3 * t[i + 2];
            Triangles.cross(p, a, b, c, normal);
            double nx = normal[0];
            double ny = normal[1];
            double nz = normal[2];
            double level = Math.sqrt(nx * nx + ny * ny);
            double twice = Math.sqrt(level * level + nz * nz);
            double x = (p[a] + p[b] + p[c]) / 3;
            double y = (p[a + 1] + p[b + 1] + p[c + 1]) / 3;
            double z = (p[a + 2] + p[b + 2] + p[c + 2]) / 3;
            double dx = x - middleX;
            double dy = y - middleY;
            if (level < MIN_HORIZONTAL_COMPONENT * twice
                    || nx * dx + ny * dy <= 0
                    || !isApposed(which != null, x, y, z)) {
                continue;
            }
            sum.area += 0.5 * twice;
            double radius = Math.sqrt(dx * dx + dy * dy);
            if (Math.abs(dx) > MIN_LATERAL_COSINE * radius) {
                sum.lateral += 0.5 * twice;
                sum.moment += 0.5 * twice * radius;
            }
        }
    }

    private boolean isApposed(boolean belowLung, double x, double y, double z) {
        return isNear(boneTrees, MAX_BONE_DISTANCE_MM, x, y, z)
                && !(belowLung && isNear(lungTrees, MIN_LUNG_DISTANCE_MM, x, y, z));
    }

    private boolean isNear(TriangleTree[] trees, double reach, double x, double y, double z) {
        return Arrays.stream(trees).anyMatch(tree -> tree.closest(x, y, z, reach, hit));
    }
}
