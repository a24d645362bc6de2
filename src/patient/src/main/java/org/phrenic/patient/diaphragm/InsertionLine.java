package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
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
 * and the crura in front of L1 to L3 on the right and L1 to L2 on the left.
 */
public final class InsertionLine {
    private static final int SECTORS = 360;
    /** Height of the insertion above the lower border of the costal margin, mm: half the height of a cartilage. */
    private static final double ABOVE_MARGIN_MM = 2;
    /** Lowest part of the sternum's height at which the diaphragm inserts, mm above its tip. */
    private static final double ABOVE_XIPHOID_MM = 12;

    private static final double CRUS_MM = 20;
    private static final double TIP_SHARE = 0.04;

    /** Azimuth (rad, -pi to pi, increasing) and height of the corners. */
    private final double[] azimuth;

    private final double[] height;
    private final CageEnvelope cage;

    public InsertionLine(Thorax body, CageEnvelope cage) {
        this.cage = cage;
        List<double[]> corners = new ArrayList<>();
        addXiphoid(body, corners);
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            addMargin(body, side, corners);
            addSpine(body, side, corners);
        }
        corners.sort(Comparator.comparingDouble(c -> c[0]));
        azimuth = corners.stream().mapToDouble(c -> c[0]).toArray();
        height = corners.stream().mapToDouble(c -> c[1]).toArray();
    }

    private void addXiphoid(Thorax body, List<double[]> corners) {
        List<TriangleMesh> sternum = body.structuresOf(StructureKind.STERNUM).stream()
                .map(Structure::mesh)
                .toList();
        if (!sternum.isEmpty()) {
            double[] tip = MeshMerge.merge(sternum).bounds();
            corners.add(new double[] {-Math.PI, tip[2] + ABOVE_XIPHOID_MM});
            corners.add(new double[] {Math.PI, tip[2] + ABOVE_XIPHOID_MM});
        }
    }

    /** Lower border of cartilages 7 to 10 and rib 10, and the tips of ribs 11 and 12. */
    private void addMargin(Thorax body, Side side, List<double[]> corners) {
        double[] lowest = new double[SECTORS];
        java.util.Arrays.fill(lowest, Double.POSITIVE_INFINITY);
        for (Structure s : body.structures()) {
            boolean margin = s.side() == side
                    && (s.kind() == StructureKind.COSTAL_CARTILAGE && s.level() >= 7
                            || s.kind() == StructureKind.RIB && s.level() >= 7 && s.level() <= 10);
            for (int v = 0; margin && v < s.mesh().vertexCount(); v++) {
                double a = cage.azimuth(s.mesh().x(v), s.mesh().y(v));
                int sector = Math.min(SECTORS - 1, (int) ((a + Math.PI) / (2 * Math.PI) * SECTORS));
                lowest[sector] = Math.min(lowest[sector], s.mesh().z(v));
            }
        }
        double sign = side == Side.LEFT ? 1 : -1;
        double[] eleven = tip(body, 11, side);
        double[] twelve = tip(body, 12, side);
        double from = eleven == null ? Math.PI / 2 : Math.abs(eleven[0]);
        for (int i = 0; i < SECTORS; i += 4) {
            double a = (i + 2.0) / SECTORS * 2 * Math.PI - Math.PI;
            double low = Double.POSITIVE_INFINITY;
            for (int k = i; k < i + 4; k++) {
                low = Math.min(low, lowest[k]);
            }
            if (a * sign > from + 0.1 && a * sign < Math.PI - 0.1 && low < Double.POSITIVE_INFINITY) {
                corners.add(new double[] {a, low + ABOVE_MARGIN_MM});
            }
        }
        if (eleven != null) {
            corners.add(eleven);
        }
        if (twelve != null && (eleven == null || Math.abs(twelve[0]) < Math.abs(eleven[0]) - 0.05)) {
            corners.add(twelve);
        }
    }

    /** Azimuth and height of the anterior end of a rib: the lowest of its vertices farthest round from the back. */
    private double[] tip(Thorax body, int level, Side side) {
        TriangleMesh rib =
                body.find(StructureKind.RIB, level, side).map(Structure::mesh).orElse(null);
        if (rib == null) {
            return null;
        }
        double[] order = new double[rib.vertexCount()];
        for (int v = 0; v < order.length; v++) {
            order[v] = Math.abs(cage.azimuth(rib.x(v), rib.y(v)));
        }
        double[] sorted = order.clone();
        java.util.Arrays.sort(sorted);
        double bound = sorted[(int) ((1 - TIP_SHARE) * (sorted.length - 1))];
        double z = Double.POSITIVE_INFINITY;
        for (int v = 0; v < order.length; v++) {
            z = order[v] >= bound ? Math.min(z, rib.z(v)) : z;
        }
        return new double[] {(side == Side.LEFT ? 1 : -1) * bound, z};
    }

    private void addSpine(Thorax body, Side side, List<double[]> corners) {
        double sign = side == Side.LEFT ? 1 : -1;
        TriangleMesh first = vertebra(body, 1);
        if (first != null) {
            double[] box = first.bounds();
            double x = side == Side.LEFT ? box[3] : box[0];
            double y = 0;
            double z = 0;
            int count = 0;
            for (int v = 0; v < first.vertexCount(); v++) {
                if (Math.abs(first.x(v) - x) < 6) {
                    y += first.y(v);
                    z += first.z(v);
                    count++;
                }
            }
            corners.add(new double[] {cage.azimuth(x, y / count), z / count});
        }
        TriangleMesh last = vertebra(body, side == Side.LEFT ? 2 : 3);
        last = last == null ? first : last;
        if (last != null) {
            double[] box = last.bounds();
            corners.add(new double[] {
                cage.azimuth(0.5 * (box[0] + box[3]) + sign * CRUS_MM, box[1]), 0.5 * (box[2] + box[5])
            });
            corners.add(new double[] {sign * 0.03, 0.5 * (box[2] + box[5])});
        }
    }

    private static TriangleMesh vertebra(Thorax body, int lumbar) {
        return body.find(StructureKind.VERTEBRA, StructureName.FIRST_LUMBAR - 1 + lumbar, Side.MIDLINE)
                .map(Structure::mesh)
                .orElse(null);
    }

    /** Height of the insertion at an azimuth, -pi to pi, mm. */
    public double height(double at) {
        int n = azimuth.length;
        int i = java.util.Arrays.binarySearch(azimuth, at);
        int high = Math.min(n - 1, Math.max(1, i < 0 ? -i - 1 : i));
        double span = Math.max(1e-9, azimuth[high] - azimuth[high - 1]);
        double t = Math.max(0, Math.min(1, (at - azimuth[high - 1]) / span));
        return height[high - 1] + t * (height[high] - height[high - 1]);
    }
}
