package org.phrenic.anatomy;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.file.ComputedArrays;
import org.phrenic.mesh.EdgePaths;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.HarmonicField;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;

/**
 * The diaphragm with its two faces, insertion, central tendon, muscle and fibre directions.
 *
 * <ul>
 *   <li>Insertion: the outer border of the sheet (xiphoid, costal margin, ribs 11 and 12, arcuate ligaments, crura).
 *       The borders of the openings for vessels and oesophagus are free.
 *   <li>Tendon: three leaflets on the roof with a given fraction of the area ({@link #TENDON_SHARE}) or, as in the
 *       paper, everything above a horizontal plane.
 *   <li>Fibres: along the gradient of a harmonic field that is 0 at the insertion and 1 at the tendon.
 * </ul>
 */
public final class Diaphragm {
    /** Area of the central tendon as a fraction of the area of a face: 143 cm² of 700 to 950 (physiology C1). */
    public static final double TENDON_SHARE = 0.14;

    /** Gradient below which the fibre direction is undefined, 1/mm; a fibre of 100 mm has a gradient of 0.01. */
    private static final double MIN_GRADIENT_PER_MM = 1e-12;

    private final TriangleMesh sheet;
    private final MedianFrame frame;
    private final TriangleMesh upright;
    private final MeshTopology topology;
    private final DiaphragmFaces faces;
    private final boolean[] inserted;
    /** Negative at vertices of the tendon. */
    private final double[] tendonField;

    private final double[] distance;
    private final double[] fibre;

    private Diaphragm(
            TriangleMesh sheet, MedianFrame frame, Function<TriangleMesh, double[]> tendon, ComputedArrays computed) {
        this.sheet = sheet;
        this.frame = frame;
        upright = frame.toFrame(sheet);
        topology = new MeshTopology(sheet);
        faces = new DiaphragmFaces(upright, topology);
        inserted = outerBorder(topology, faces);
        distance = distancesFromInsertion(sheet, topology, inserted);
        tendonField = tendon.apply(upright);
        fibre = computed.get("fibres", sheet.triangles().length, this::computeFibreDirections);
    }

    /** Of the shells of a mesh that which is the sheet: the closed one, facing outward, with most vertices. */
    public static Optional<TriangleMesh> sheetAmong(TriangleMesh shells) {
        return ConnectedComponents.of(shells).stream()
                .filter(shell -> new EdgeTable(shell).isClosed() && MeshMeasure.signedVolume(shell) > 0)
                .max(Comparator.comparingInt(TriangleMesh::vertexCount));
    }

    /** Creates a diaphragm with a tendon of three leaflets. */
    public static Diaphragm withTrefoilTendon(TriangleMesh sheet) {
        return withTrefoilTendon(sheet, MedianFrame.straight(), ComputedArrays.none());
    }

    /**
     * Creates a diaphragm with a tendon of three leaflets, with fibres that may be known.
     *
     * @param frame frame of the body, in which leaflets, right and left are told
     */
    public static Diaphragm withTrefoilTendon(TriangleMesh sheet, MedianFrame frame, ComputedArrays computed) {
        return new Diaphragm(sheet, frame, upright -> CentralTendon.field(upright, TENDON_SHARE), computed);
    }

    /**
     * Creates a diaphragm whose tendon is everything above a horizontal plane, as in the paper.
     *
     * @param frame frame of the body, in which the plane is horizontal
     * @param height height of the plane in that frame, mm
     */
    public static Diaphragm withTendonAbovePlane(TriangleMesh sheet, MedianFrame frame, double height) {
        return new Diaphragm(sheet, frame, upright -> heightsBelow(upright, height), ComputedArrays.none());
    }

    private static double[] heightsBelow(TriangleMesh upright, double height) {
        double[] below = new double[upright.vertexCount()];
        Arrays.setAll(below, i -> height - upright.z(i));
        return below;
    }

    /** Marks the largest connected component of border vertices; openings are separate components. */
    private static boolean[] outerBorder(MeshTopology topology, DiaphragmFaces faces) {
        int n = faces.vertexCount();
        int[] runs = DisjointSets.singletons(n);
        int[] edges = topology.edges();
        for (int e = 0; e < edges.length; e += 2) {
            if (faces.isBorder(edges[e]) && faces.isBorder(edges[e + 1])) {
                DisjointSets.unionToLower(runs, edges[e], edges[e + 1]);
            }
        }
        int[] border = IntStream.range(0, n).filter(faces::isBorder).toArray();
        int[] size = new int[n];
        IntStream.of(border).forEach(i -> size[DisjointSets.find(runs, i)]++);
        int largest = -1;
        for (int i : border) {
            largest = largest < 0 || size[DisjointSets.find(runs, i)] > size[largest]
                    ? DisjointSets.find(runs, i)
                    : largest;
        }
        boolean[] out = new boolean[n];
        for (int i : border) {
            out[i] = DisjointSets.find(runs, i) == largest;
        }
        return out;
    }

    private static double[] distancesFromInsertion(TriangleMesh sheet, MeshTopology topology, boolean[] inserted) {
        int[] sources =
                IntStream.range(0, inserted.length).filter(i -> inserted[i]).toArray();
        if (sources.length == 0) {
            double[] nowhere = new double[inserted.length];
            Arrays.fill(nowhere, Double.POSITIVE_INFINITY);
            return nowhere;
        }
        return EdgePaths.distances(sheet, topology, sources);
    }

    /** Unit fibre direction of each triangle; zero in the tendon. */
    private double[] computeFibreDirections() {
        int[] held = IntStream.range(0, inserted.length)
                .filter(i -> inserted[i] || isTendon(i))
                .toArray();
        double[] out = new double[sheet.triangles().length];
        if (held.length == 0) {
            return out;
        }
        double[] given =
                IntStream.of(held).mapToDouble(i -> isTendon(i) ? 1 : 0).toArray();
        double[] gradient = HarmonicField.solve(sheet, topology, held, given).gradients();
        for (int t = 0; t < sheet.triangleCount(); t++) {
            double length = Math.sqrt(gradient[3 * t] * gradient[3 * t]
                    + gradient[3 * t + 1] * gradient[3 * t + 1]
                    + gradient[3 * t + 2] * gradient[3 * t + 2]);
            if (isTendonTriangle(t) || !(length > MIN_GRADIENT_PER_MM)) {
                continue;
            }
            for (int axis = 0; axis < 3; axis++) {
                out[3 * t + axis] = gradient[3 * t + axis] / length;
            }
        }
        return out;
    }

    public TriangleMesh sheet() {
        return sheet;
    }

    /** The sheet in the frame of the body, for what is told by directions: right, front, the roof. */
    public TriangleMesh upright() {
        return upright;
    }

    /** Frame of the body. */
    public MedianFrame frame() {
        return frame;
    }

    public MeshTopology topology() {
        return topology;
    }

    public boolean isThoracic(int vertex) {
        return faces.isThoracic(vertex);
    }

    /** True if the vertex lies on the insertion. */
    public boolean isInserted(int vertex) {
        return inserted[vertex];
    }

    public boolean isTendon(int vertex) {
        return tendonField[vertex] < 0;
    }

    /** Part of an edge, between two vertices, that lies within the border of the tendon, 0 to 1. */
    public double tendonShare(int a, int b) {
        if (isTendon(a) == isTendon(b)) {
            return isTendon(a) ? 1 : 0;
        }
        double inside = Math.min(tendonField[a], tendonField[b]);
        double outside = Math.max(tendonField[a], tendonField[b]);
        return inside / (inside - outside);
    }

    /**
     * Part of a triangle's area that lies within the border of the tendon.
     *
     * @param area that of the triangle, as it is deformed
     */
    public double tendonArea(int triangle, double area) {
        int[] t = sheet.triangles();
        return CentralTendon.areaWithin(
                area, tendonField[t[3 * triangle]], tendonField[t[3 * triangle + 1]], tendonField[t[3 * triangle + 2]]);
    }

    /** Distance along edges of the sheet from the insertion, mm. */
    public double distanceFromInsertion(int vertex) {
        return distance[vertex];
    }

    /**
     * Unit fibre direction of each triangle, three numbers each; zero in the tendon. The array must not be modified.
     */
    public double[] fibreDirections() {
        return fibre;
    }

    /** True if all corners of a triangle are tendon. */
    public boolean isTendonTriangle(int triangle) {
        int[] t = sheet.triangles();
        return isTendon(t[3 * triangle]) && isTendon(t[3 * triangle + 1]) && isTendon(t[3 * triangle + 2]);
    }

    /** True if at least two corners of a triangle lie on the thoracic face. */
    public boolean isThoracicTriangle(int triangle) {
        int[] t = sheet.triangles();
        int count = 0;
        for (int c = 0; c < 3; c++) {
            count += faces.isThoracic(t[3 * triangle + c]) ? 1 : 0;
        }
        return count >= 2;
    }
}
