package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;

/**
 * The line of insertion as a height over the azimuth about the cage's axis: back of the xiphoid, inner faces of the
 * costal cartilages 7 to 10 at the costal margin, tips of ribs 11 and 12, transverse process of L1 (arcuate ligaments),
 * and the crura in front of L1 to L3 on the right and L1 to L2 on the left. The line through these corners is smoothed
 * over {@value #SMOOTHING_DEG} degrees.
 */
final class InsertionLine {
    private static final int SECTORS = 360;
    /** Depth of the insertion below the lowest vertex of the costal margin at an azimuth, mm. */
    private static final double BELOW_MARGIN_MM = 4;
    /** Height of the insertion above the tip of the sternum, mm. */
    private static final double ABOVE_XIPHOID_MM = 12;
    /** Depth of the arcuate ligaments below the transverse process of L1, mm: its lower border and that of L2 above. */
    private static final double BELOW_PROCESS_MM = 15;
    /** Greatest depth of the insertion on rib 12 below the arcuate ligaments, mm: the middle of L2. */
    private static final double BELOW_ARCUATE_MM = 15;
    /** Half-breadth of the crura in front of the vertebral bodies, mm. */
    private static final double CRUS_MM = 24;
    /** Share of a rib's vertices that form its tip. */
    private static final double TIP_SHARE = 0.04;

    private static final double SMOOTHING_DEG = 3;
    private static final double MARGIN_RAD = 0.05;
    private static final double PROCESS_MM = 6;

    /** Height at each degree of azimuth, from -180 degrees on, and once more at 180 degrees. */
    private final double[] height = new double[SECTORS + 1];

    private final double marginAzimuth;
    private final CageEnvelope cage;

    /**
     * @param cage envelope of the same body
     * @param ceiling greatest height, mm; a diaphragm does not insert above its domes, however flat they are
     */
    InsertionLine(Thorax body, CageEnvelope cage, double ceiling) {
        this.cage = cage;
        List<double[]> corners = new ArrayList<>();
        addXiphoid(body, corners);
        double most = 0;
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            most = Math.max(most, addMargin(body, side, corners));
            addSpine(body, side, corners);
        }
        marginAzimuth = most;
        corners.sort(Comparator.comparingDouble(c -> c[0]));
        double[] raw = new double[SECTORS + 1];
        for (int i = 0; i <= SECTORS; i++) {
            raw[i] = Math.min(ceiling, between(corners, Math.toRadians(i - 180.0)));
        }
        smooth(raw);
    }

    /** Gaussian smoothing over the azimuth. */
    private void smooth(double[] raw) {
        int reach = (int) Math.ceil(3 * SMOOTHING_DEG);
        for (int i = 0; i <= SECTORS; i++) {
            double sum = 0;
            double total = 0;
            for (int k = -reach; k <= reach; k++) {
                double weight = StrictMath.exp(-0.5 * k * k / (SMOOTHING_DEG * SMOOTHING_DEG));
                sum += weight * raw[Math.floorMod(i + k, SECTORS)];
                total += weight;
            }
            height[i] = sum / total;
        }
    }

    private static double between(List<double[]> corners, double at) {
        int high = 1;
        while (high < corners.size() - 1 && corners.get(high)[0] < at) {
            high++;
        }
        double[] a = corners.get(high - 1);
        double[] b = corners.get(high);
        double t = Math.max(0, Math.min(1, (at - a[0]) / Math.max(1e-9, b[0] - a[0])));
        return a[1] + t * (b[1] - a[1]);
    }

    private static void addXiphoid(Thorax body, List<double[]> corners) {
        List<TriangleMesh> sternum = body.structuresOf(StructureKind.STERNUM).stream()
                .map(Structure::mesh)
                .toList();
        if (!sternum.isEmpty()) {
            double z = MeshMerge.merge(sternum).bounds()[2] + ABOVE_XIPHOID_MM;
            corners.add(new double[] {-Math.PI, z});
            corners.add(new double[] {Math.PI, z});
        }
    }

    /**
     * Adds the lower border of cartilages 7 to 10 and ribs 7 to 10, and the tips of ribs 11 and 12. Returns the azimuth
     * from the back at which the costal margin begins.
     */
    private double addMargin(Thorax body, Side side, List<double[]> corners) {
        double[] lowest = lowest(body, side);
        double sign = side == Side.LEFT ? 1 : -1;
        Optional<double[]> eleven = tip(body, 11, side);
        Optional<double[]> twelve = tip(body, 12, side);
        double from = eleven.map(c -> Math.abs(c[0])).orElse(Math.PI / 2);
        for (int i = 0; i < SECTORS; i++) {
            double a = (i + 0.5) / SECTORS * 2 * Math.PI - Math.PI;
            boolean onMargin = a * sign > from + MARGIN_RAD && a * sign < Math.PI - MARGIN_RAD;
            if (onMargin && lowest[i] < Double.POSITIVE_INFINITY) {
                corners.add(new double[] {a, lowest[i] - BELOW_MARGIN_MM});
            }
        }
        eleven.ifPresent(corners::add);
        Optional<double[]> process = process(body, side);
        twelve.filter(c -> Math.abs(c[0]) < from - MARGIN_RAD)
                .map(c -> new double[] {
                    c[0],
                    Math.max(c[1], process.map(p -> p[1] - BELOW_ARCUATE_MM).orElse(c[1]))
                })
                .ifPresent(corners::add);
        return from;
    }

    /** Lowest vertex of cartilages and ribs 7 to 10 of a side in each sector. */
    private double[] lowest(Thorax body, Side side) {
        double[] lowest = new double[SECTORS];
        Arrays.fill(lowest, Double.POSITIVE_INFINITY);
        for (Structure s : body.structures()) {
            boolean margin = s.side() == side
                    && s.level() >= 7
                    && s.level() <= 10
                    && (s.kind() == StructureKind.COSTAL_CARTILAGE || s.kind() == StructureKind.RIB);
            for (int v = 0; margin && v < s.mesh().vertexCount(); v++) {
                double a = cage.azimuth(s.mesh().x(v), s.mesh().y(v));
                int sector = Math.min(SECTORS - 1, (int) ((a + Math.PI) / (2 * Math.PI) * SECTORS));
                lowest[sector] = Math.min(lowest[sector], s.mesh().z(v));
            }
        }
        return lowest;
    }

    /** Azimuth and height of the anterior end of a rib: its vertices farthest round from the back, and their lowest. */
    private Optional<double[]> tip(Thorax body, int level, Side side) {
        return body.find(StructureKind.RIB, level, side).map(s -> {
            TriangleMesh rib = s.mesh();
            double[] order = new double[rib.vertexCount()];
            Arrays.setAll(order, v -> Math.abs(cage.azimuth(rib.x(v), rib.y(v))));
            double[] sorted = order.clone();
            Arrays.sort(sorted);
            double bound = sorted[(int) ((1 - TIP_SHARE) * (sorted.length - 1))];
            double z = Double.POSITIVE_INFINITY;
            for (int v = 0; v < order.length; v++) {
                z = order[v] >= bound ? Math.min(z, rib.z(v)) : z;
            }
            return new double[] {(side == Side.LEFT ? 1 : -1) * bound, z};
        });
    }

    /** Azimuth and height of the arcuate ligaments at the tip of the transverse process of L1. */
    private Optional<double[]> process(Thorax body, Side side) {
        return vertebra(body, 1).map(mesh -> {
            double[] box = mesh.bounds();
            double x = side == Side.LEFT ? box[3] : box[0];
            double y = 0;
            double z = 0;
            int count = 0;
            for (int v = 0; v < mesh.vertexCount(); v++) {
                if (Math.abs(mesh.x(v) - x) < PROCESS_MM) {
                    y += mesh.y(v);
                    z += mesh.z(v);
                    count++;
                }
            }
            return new double[] {cage.azimuth(x, y / count), z / count - BELOW_PROCESS_MM};
        });
    }

    private void addSpine(Thorax body, Side side, List<double[]> corners) {
        double sign = side == Side.LEFT ? 1 : -1;
        process(body, side).ifPresent(corners::add);
        vertebra(body, side == Side.LEFT ? 2 : 3).or(() -> vertebra(body, 1)).ifPresent(mesh -> {
            double[] box = mesh.bounds();
            double z = 0.5 * (box[2] + box[5]);
            corners.add(new double[] {cage.azimuth(0.5 * (box[0] + box[3]) + sign * CRUS_MM, box[1]), z});
            corners.add(new double[] {sign * 0.03, z});
        });
    }

    private static Optional<TriangleMesh> vertebra(Thorax body, int lumbar) {
        return body.find(StructureKind.VERTEBRA, StructureName.FIRST_LUMBAR - 1 + lumbar, Side.MIDLINE)
                .map(Structure::mesh);
    }

    /** Azimuth from the back beyond which the insertion lies on the costal margin: that of the tip of rib 11, rad. */
    double marginAzimuth() {
        return marginAzimuth;
    }

    /** Height of the insertion at an azimuth, -pi to pi, mm. */
    double height(double azimuth) {
        double at = Math.max(0, Math.min(SECTORS, Math.toDegrees(azimuth) + 180));
        int i = Math.min(SECTORS - 1, (int) at);
        return height[i] + (at - i) * (height[i + 1] - height[i]);
    }
}
