package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.PatientStructure;

/** A surface of the scan and the corresponding surface of the template, with their nearest points. */
final class SurfacePair {
    /** Number of sample points on each surface. */
    private static final int POINTS = 500;
    /** Vertices closer than this to the boundary of the scan belong to the cut, mm. */
    static final double CUT_MM = 8;

    /** Pairs are farther apart than usual beyond this multiple of the median distance. */
    private static final double OUTLIER = 2.5;

    /** Kinds of which the part beyond a cut is nearest to the cut. */
    private static final Set<StructureKind> IN_A_LINE =
            EnumSet.of(StructureKind.RIB, StructureKind.COSTAL_CARTILAGE, StructureKind.STERNUM);

    private final StructureKind kind;
    private final TriangleMesh scan;
    private final TriangleTree scanTree;
    private final boolean whole;
    /** Whether points of the template beyond a cut of the scan are nearest to it. */
    private final boolean inALine;

    private final boolean[] atCut;
    /** Triangles of the scan at the border of an open surface or at the end of the scan. */
    private final boolean[] atScanBorder;

    private final boolean[] atTemplateBorder;
    /** Surface of the template at its original place. */
    private final TriangleMesh rest;

    private TriangleMesh template;
    private final TriangleTree templateTree;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    /**
     * Pairs a surface, or a part of one, with its counterpart.
     *
     * @param guidesBones whether bones follow the surface; false for the base of a lung
     */
    SurfacePair(PatientStructure organ, TriangleMesh scan, TriangleMesh template, boolean guidesBones) {
        kind = organ.structure().kind();
        this.scan = scan;
        scanTree = new TriangleTree(scan);
        whole = organ.isComplete();
        inALine = IN_A_LINE.contains(kind) && (kind != StructureKind.STERNUM || organ.isCutAlongBody());
        atCut = atCut(organ, scan);
        rest = template;
        this.template = template;
        templateTree = new TriangleTree(template);
        atScanBorder = atBorder(scan, guidesBones);
        for (int i = 0; i < scan.triangles().length; i++) {
            atScanBorder[i / 3] |= atCut[scan.triangles()[i]];
        }
        atTemplateBorder = atBorder(template, guidesBones);
    }

    /**
     * Marks triangles at the border of an open surface. Points nearest to these triangles lie beyond the surface and
     * have no counterpart.
     */
    private static boolean[] atBorder(TriangleMesh mesh, boolean counts) {
        boolean[] at = new boolean[mesh.triangleCount()];
        if (counts) {
            boolean[] border = new boolean[mesh.vertexCount()];
            for (int[] loop : new MeshTopology(mesh).boundaryLoops()) {
                for (int v : loop) {
                    border[v] = true;
                }
            }
            for (int i = 0; i < mesh.triangles().length; i++) {
                at[i / 3] |= border[mesh.triangles()[i]];
            }
        }
        return at;
    }

    /** Marks the vertices of a surface, or of a part of it, at the boundary of the scan. */
    private static boolean[] atCut(PatientStructure organ, TriangleMesh part) {
        boolean[] ofOrgan = organ.verticesAtCut(CUT_MM);
        TriangleMesh whole = organ.structure().mesh();
        Set<List<Double>> cut = new HashSet<>();
        for (int v = 0; v < ofOrgan.length; v++) {
            if (ofOrgan[v]) {
                cut.add(List.of(whole.x(v), whole.y(v), whole.z(v)));
            }
        }
        boolean[] atCut = new boolean[part.vertexCount()];
        for (int v = 0; v < atCut.length; v++) {
            atCut[v] = cut.contains(List.of(part.x(v), part.y(v), part.z(v)));
        }
        return atCut;
    }

    StructureKind kind() {
        return kind;
    }

    boolean isComplete() {
        return whole;
    }

    /** Moves the surface of the template from its original place. */
    void place(PointTransform map) {
        template = map.apply(rest);
        templateTree.refit(template.positions());
    }

    /**
     * Pairs of original points of the template and points of the scan, nearest to each other as the template is placed.
     * Pairs much farther apart than half of all count less. Points nearest to a cut have no counterpart. Of a structure
     * that the scan cuts off, points of the template count only where it is long and thin and cut across.
     *
     * @param count number of points of each surface
     * @param sigmaMm standard deviation of a pair
     */
    PointPairs nearest(int count, double sigmaMm) {
        DoubleList from = new DoubleList();
        DoubleList to = new DoubleList();
        DoubleList distance = new DoubleList();
        double[] s = scan.positions();
        int n = Math.min(count, scan.vertexCount());
        for (int i = 0; i < n; i++) {
            int v = (int) ((long) i * scan.vertexCount() / n);
            if (!atCut[v]
                    && templateTree.closest(s[3 * v], s[3 * v + 1], s[3 * v + 2], hit)
                    && !atTemplateBorder[hit.triangle]) {
                addRest(from);
                to.add(s[3 * v], s[3 * v + 1], s[3 * v + 2]);
                distance.add(Math.sqrt(hit.distanceSquared));
            }
        }
        double[] t = template.positions();
        double[] r = rest.positions();
        n = Math.min(count, template.vertexCount());
        boolean fromTemplate = whole || inALine;
        for (int i = 0; fromTemplate && i < n; i++) {
            int v = (int) ((long) i * template.vertexCount() / n);
            if (scanTree.closest(t[3 * v], t[3 * v + 1], t[3 * v + 2], hit) && !atScanBorder[hit.triangle]) {
                from.add(r[3 * v], r[3 * v + 1], r[3 * v + 2]);
                to.add(hit.x, hit.y, hit.z);
                distance.add(Math.sqrt(hit.distanceSquared));
            }
        }
        return robust(from.toArray(), to.toArray(), distance.toArray(), sigmaMm);
    }

    /** Adds the original place of the point of the template that was hit. */
    private void addRest(DoubleList out) {
        int[] corners = rest.triangles();
        double[] r = rest.positions();
        int a = 3 * corners[3 * hit.triangle];
        int b = 3 * corners[3 * hit.triangle + 1];
        int c = 3 * corners[3 * hit.triangle + 2];
        for (int k = 0; k < 3; k++) {
            out.add(hit.weightA * r[a + k] + hit.weightB * r[b + k] + hit.weightC * r[c + k]);
        }
    }

    private static PointPairs robust(double[] from, double[] to, double[] distance, double sigmaMm) {
        double[] sorted = distance.clone();
        Arrays.sort(sorted);
        double usual = sorted.length == 0 ? 0 : OUTLIER * sorted[sorted.length / 2] + 1;
        PointPairs pairs = new PointPairs();
        for (int i = 0; i < distance.length; i++) {
            pairs.add(
                    Arrays.copyOfRange(from, 3 * i, 3 * i + 3),
                    Arrays.copyOfRange(to, 3 * i, 3 * i + 3),
                    sigmaMm * Math.max(1, distance[i] / usual));
        }
        return pairs;
    }

    void transformTemplate(PointTransform map) {
        template = map.apply(template);
        templateTree.refit(template.positions());
    }

    /** Points of the template and their counterparts on the scan, in the same order. */
    record Correspondences(List<double[]> from, List<double[]> to) {}

    /** Nearest points in both directions. For a truncated scan, only from its own points to the template. */
    Correspondences correspondences() {
        List<double[]> from = new ArrayList<>();
        List<double[]> to = new ArrayList<>();
        double[] s = scan.positions();
        int step = Math.max(1, scan.vertexCount() / POINTS);
        for (int v = 0; v < scan.vertexCount(); v += step) {
            if (!atCut[v]
                    && templateTree.closest(s[3 * v], s[3 * v + 1], s[3 * v + 2], hit)
                    && !atTemplateBorder[hit.triangle]) {
                from.add(new double[] {hit.x, hit.y, hit.z});
                to.add(new double[] {s[3 * v], s[3 * v + 1], s[3 * v + 2]});
            }
        }
        double[] t = template.positions();
        step = Math.max(1, template.vertexCount() / POINTS);
        for (int v = 0; whole && v < template.vertexCount(); v += step) {
            if (scanTree.closest(t[3 * v], t[3 * v + 1], t[3 * v + 2], hit) && !atScanBorder[hit.triangle]) {
                from.add(new double[] {t[3 * v], t[3 * v + 1], t[3 * v + 2]});
                to.add(new double[] {hit.x, hit.y, hit.z});
            }
        }
        return new Correspondences(from, to);
    }

    /** Area-weighted distances from the vertices of a scanned structure to the template, excluding the cut. */
    static DistanceSummary distanceToScan(PatientStructure organ, TriangleMesh template) {
        TriangleMesh scan = organ.structure().mesh();
        boolean[] atCut = atCut(organ, scan);
        double[] weights = MeshMeasure.vertexAreas(scan);
        for (int v = 0; v < weights.length; v++) {
            weights[v] = atCut[v] ? 0 : weights[v];
        }
        return DistanceSummary.of(new SurfaceDistance(template).unsignedDistance(scan.positions()), weights);
    }
}
