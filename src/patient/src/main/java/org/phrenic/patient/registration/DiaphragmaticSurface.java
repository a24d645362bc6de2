package org.phrenic.patient.registration;

import java.util.Arrays;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The diaphragmatic surface (base) of a lung. It is found from the shape alone, so scans and simulations are treated in
 * the same way.
 *
 * <p>Candidate faces are downward facing: with the lung scaled to equal height and depth, the z component of the
 * smoothed outward normal is below {@value #MAX_NORMAL_Z}. They must also have no lung below them. The result is the
 * connected region of candidates with the largest area, including the faces that it encloses in its piece of the
 * surface: other pieces, such as the walls of cavities, are no part of it. Downward facing parts of hilum and fissures
 * have lung below them or form separate regions.
 */
public final class DiaphragmaticSurface {
    /**
     * Corresponds to 33 degrees from the vertical. Steeper faces are costal or mediastinal; the heart undercuts the
     * lungs by up to 30 degrees.
     */
    static final double MAX_NORMAL_Z = -0.55;

    private static final int SMOOTHINGS = 3;
    /** Offset of a ray's origin below its triangle, mm. */
    private static final double CLEAR_MM = 0.5;

    private DiaphragmaticSurface() {}

    /**
     * Returns the diaphragmatic surface as a mesh.
     *
     * @param lung closed mesh of one lung, LPS, mm
     * @return mesh without triangles if no face is downward facing
     */
    public static TriangleMesh of(TriangleMesh lung) {
        return part(lung, triangleMask(lung), true);
    }

    /** The lung surface without its diaphragmatic surface. */
    static TriangleMesh complement(TriangleMesh lung) {
        return part(lung, triangleMask(lung), false);
    }

    private static TriangleMesh part(TriangleMesh lung, boolean[] mask, boolean wanted) {
        int[] place = new int[lung.vertexCount()];
        Arrays.fill(place, -1);
        int[] corners = new int[lung.triangles().length];
        double[] p = new double[lung.positions().length];
        int vertices = 0;
        int count = 0;
        for (int t = 0; t < mask.length; t++) {
            for (int c = 3 * t; mask[t] == wanted && c < 3 * t + 3; c++) {
                int v = lung.triangles()[c];
                if (place[v] < 0) {
                    System.arraycopy(lung.positions(), 3 * v, p, 3 * vertices, 3);
                    place[v] = vertices++;
                }
                corners[count++] = place[v];
            }
        }
        return new TriangleMesh(Arrays.copyOf(p, 3 * vertices), Arrays.copyOf(corners, count));
    }

    /** Whether each vertex belongs to the diaphragmatic surface. */
    public static boolean[] vertexMask(TriangleMesh lung) {
        boolean[] mask = triangleMask(lung);
        boolean[] corner = new boolean[lung.vertexCount()];
        for (int c = 0; c < lung.triangles().length; c++) {
            corner[lung.triangles()[c]] |= mask[c / 3];
        }
        return corner;
    }

    /** Whether each triangle belongs to the diaphragmatic surface. */
    public static boolean[] triangleMask(TriangleMesh lung) {
        double[] normals = smoothed(lung);
        double outward = MeshMeasure.signedVolume(lung) < 0 ? -1 : 1;
        TriangleTree tree = new TriangleTree(lung);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int[] t = lung.triangles();
        boolean[] down = new boolean[lung.triangleCount()];
        for (int i = 0; i < down.length; i++) {
            double up = 0;
            for (int c = 3 * i; c < 3 * i + 3; c++) {
                up += outward * normals[3 * t[c] + 2] / 3;
            }
            double[] middle = MeshMeasure.centroid(lung, i);
            down[i] = up < MAX_NORMAL_Z
                    && tree.countAlongRay(middle[0], middle[1], middle[2] - CLEAR_MM, 0, 0, -1, hit) == 0;
        }
        MeshTopology topology = new MeshTopology(lung);
        keepLargest(lung, topology, down);
        includeEnclosed(lung, topology, down);
        return down;
    }

    /** Includes steep faces that a region encloses: all faces of its piece of the surface but the largest rest. */
    private static void includeEnclosed(TriangleMesh lung, MeshTopology topology, boolean[] region) {
        int[] parent = DisjointSets.singletons(region.length);
        for (int edge = 0; edge < topology.edgeCount(); edge++) {
            for (int i = 1; i < topology.faceCount(edge); i++) {
                DisjointSets.unionToLower(parent, topology.face(edge, 0), topology.face(edge, i));
            }
        }
        int piece = MeshTopology.NONE;
        for (int i = 0; i < region.length; i++) {
            piece = region[i] ? DisjointSets.find(parent, i) : piece;
        }
        boolean[] rest = new boolean[region.length];
        for (int i = 0; i < rest.length; i++) {
            rest[i] = !region[i] && DisjointSets.find(parent, i) == piece;
        }
        keepLargest(lung, topology, rest);
        for (int i = 0; i < rest.length; i++) {
            region[i] = !rest[i] && DisjointSets.find(parent, i) == piece;
        }
    }

    /** Scales the lung to equal height and depth, so that its proportions and a wrong slice spacing have no effect. */
    private static TriangleMesh inProportion(TriangleMesh lung) {
        double[] box = lung.bounds();
        double[] p = lung.positions().clone();
        for (int z = 2; z < p.length; z += 3) {
            p[z] *= (box[4] - box[1]) / (box[5] - box[2]);
        }
        return lung.withPositions(p);
    }

    /** Unit vertex normals, smoothed by repeated averaging with the neighbours. */
    private static double[] smoothed(TriangleMesh lung) {
        double[] normals = MeshMeasure.vertexNormals(inProportion(lung));
        int[] t = lung.triangles();
        for (int round = 0; round < SMOOTHINGS; round++) {
            double[] sum = new double[normals.length];
            for (int i = 0; i < t.length; i++) {
                int other = i % 3 == 2 ? t[i - 2] : t[i + 1];
                for (int k = 0; k < 3; k++) {
                    // Each edge is visited from both adjacent triangles, once for each of its ends.
                    sum[3 * t[i] + k] += normals[3 * t[i] + k] + normals[3 * other + k];
                }
            }
            for (int v = 0; v < sum.length; v += 3) {
                double length = Math.sqrt(sum[v] * sum[v] + sum[v + 1] * sum[v + 1] + sum[v + 2] * sum[v + 2]);
                for (int k = v; k < v + 3; k++) {
                    normals[k] = sum[k] / Math.max(length, Double.MIN_NORMAL);
                }
            }
        }
        return normals;
    }

    /** Keeps the edge-connected region with the largest area. */
    private static void keepLargest(TriangleMesh lung, MeshTopology topology, boolean[] member) {
        int[] piece = new int[member.length];
        int[] queue = new int[member.length];
        double[] cross = new double[3];
        int pieces = 0;
        int best = 0;
        double most = 0;
        for (int seed = 0; seed < member.length; seed++) {
            if (!member[seed] || piece[seed] > 0) {
                continue;
            }
            piece[seed] = ++pieces;
            queue[0] = seed;
            int length = 1;
            double area = 0;
            for (int at = 0; at < length; at++) {
                area += 0.5 * MeshMeasure.triangleCrossProduct(lung, queue[at], cross);
                for (int side = 0; side < 3; side++) {
                    int edge = topology.edgeOfSide()[3 * queue[at] + side];
                    int faces = edge == MeshTopology.NONE ? 0 : topology.faceCount(edge);
                    for (int i = 0; i < faces; i++) {
                        int next = topology.face(edge, i);
                        if (member[next] && piece[next] == 0) {
                            piece[next] = pieces;
                            queue[length++] = next;
                        }
                    }
                }
            }
            if (area > most) {
                most = area;
                best = pieces;
            }
        }
        for (int i = 0; i < member.length; i++) {
            member[i] = best > 0 && piece[i] == best;
        }
    }
}
