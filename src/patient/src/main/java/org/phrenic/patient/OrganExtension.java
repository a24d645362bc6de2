package org.phrenic.patient;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.mesh.voxel.DistanceTransform;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * An organ that the end of a scan truncates, continued by a registered template. Its surface is the zero level of
 *
 * <pre>
 * (1 - w) s + w t,   w = 1 - h(d / {@value #BAND_MM} mm),   h(x) = 3 x^2 - 2 x^3 for x in 0 to 1
 * </pre>
 *
 * with the signed distances s to the surface of the scan and t to that of the template, in a grid of {@value #CELL_MM}
 * mm, and the depth d of a point below the end of the scan. So the surface is the template's beyond the end of the scan
 * and the scan's from the depth of {@value #BAND_MM} mm on; vertices there are put on the surface of the scan. Pieces
 * of the organ that lie apart in the scan are kept.
 */
public final class OrganExtension {
    private static final double CELL_MM = 2;
    private static final double BAND_MM = 20;
    private static final int MARGIN = 3;
    /** Least volume of a further piece over the template's: parts of a thin recess are less. */
    private static final double LEAST_SHARE = 0.02;

    /** Greatest distance from the surface of the scan at which a vertex is put on it, mm. */
    private static final double NEAR_MM = 2 * CELL_MM;

    private final PatientStructure organ;
    private final TriangleMesh scan;
    private final ShownPlaces places;

    private OrganExtension(PatientStructure organ) {
        this.organ = organ;
        scan = organ.structure().mesh();
        places = new ShownPlaces(scan, organ.shown().positions());
    }

    /**
     * Returns the surface of the continued organ.
     *
     * @param organ an organ that the scan truncates, with a closed surface, mm
     * @param template closed surface of the whole organ where the scan shows it, mm
     * @throws IllegalArgumentException if the scan does not truncate the organ
     */
    public static TriangleMesh extended(PatientStructure organ, TriangleMesh template) {
        if (organ.isComplete()) {
            throw new IllegalArgumentException(organ.structure().name() + " is whole, expected one that is cut off");
        }
        return new OrganExtension(organ).extended(template);
    }

    private TriangleMesh extended(TriangleMesh template) {
        VoxelBox box = around(scan.bounds(), template.bounds());
        float[] s = signedDistances(scan, box);
        float[] t = signedDistances(template, box);
        byte[] labels = new byte[s.length];
        double[] p = new double[3];
        for (int cell = 0; cell < labels.length; cell++) {
            boolean inside = s[cell] < 0;
            if (inside != (t[cell] < 0)) {
                int row = cell / box.columns();
                int layer = row / box.rows();
                box.voxelToMm(cell % box.columns(), row % box.rows(), layer, p);
                double weight = templateWeight(depth(p));
                inside = (1 - weight) * s[cell] + weight * t[cell] < 0;
            }
            labels[cell] = (byte) (inside ? 1 : 0);
        }
        LabelGrid grid = LabelGrid.of(box.columns(), box.rows(), box.slices(), labels, box.toMm());
        SegmentMesher mesher = new SegmentMesher(grid, new int[] {0, 1}, MeshingSettings.PAPER);
        double least = LEAST_SHARE * MeshMeasure.signedVolume(template);
        return onScan(
                mesher.surface(1, edge(scan), piece -> MeshMeasure.signedVolume(piece) > least && isOfScan(piece)));
    }

    /** Whether a piece reaches so deep that the scan has more weight than the template there. */
    private boolean isOfScan(TriangleMesh piece) {
        return IntStream.range(0, piece.vertexCount())
                .mapToObj(v -> new double[] {piece.x(v), piece.y(v), piece.z(v)})
                .anyMatch(p -> templateWeight(depth(p)) < 0.5);
    }

    /** A box around two others. */
    private static VoxelBox around(double[] a, double[] b) {
        double[] low = new double[3];
        int[] size = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(a[axis], b[axis]) - MARGIN * CELL_MM;
            double high = Math.max(a[3 + axis], b[3 + axis]) + MARGIN * CELL_MM;
            size[axis] = 1 + (int) Math.ceil((high - low[axis]) / CELL_MM);
        }
        return new VoxelBox(size, new double[] {CELL_MM, 0, 0, low[0], 0, CELL_MM, 0, low[1], 0, 0, CELL_MM, low[2]});
    }

    private static double edge(TriangleMesh mesh) {
        return MeshMeasure.edgeLengthSummary(mesh, new MeshTopology(mesh)).mean();
    }

    /** Signed distances of the cells from a surface, in cells, negative inside. */
    private static float[] signedDistances(TriangleMesh mesh, VoxelBox box) {
        byte[] labels = new byte[box.voxels()];
        new MeshVoxelizer(box.columns(), box.rows(), box.slices(), box.toVoxel(), labels).fill(mesh, 1);
        boolean[] inside = new boolean[labels.length];
        for (int cell = 0; cell < labels.length; cell++) {
            inside[cell] = labels[cell] != 0;
        }
        return DistanceTransform.signed(inside, box.size());
    }

    private static double templateWeight(double depthMm) {
        double x = Math.max(0, Math.min(1, depthMm / BAND_MM));
        return 1 - x * x * (3 - 2 * x);
    }

    /** Depth of a point below the ends of the scan, mm, wherever what the scan shows has been moved since. */
    private double depth(double[] p) {
        double[] there = p.clone();
        places.apply(there, 0);
        return depthWhereShown(there);
    }

    private double depthWhereShown(double[] there) {
        return organ.cuts().stream()
                .mapToDouble((CutPlane cut) -> cut.depth(there))
                .min()
                .orElseThrow();
    }

    /** Puts the vertices of which the scan shows the surface onto it. */
    private TriangleMesh onScan(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            double[] there = Arrays.copyOfRange(p, i, i + 3);
            TriangleTree.Hit hit = places.apply(there, 0);
            if (depthWhereShown(there) >= BAND_MM && hit.distanceSquared < NEAR_MM * NEAR_MM) {
                p[i] = hit.x;
                p[i + 1] = hit.y;
                p[i + 2] = hit.z;
            }
        }
        return mesh.withPositions(p);
    }
}
