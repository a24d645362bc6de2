package org.phrenic.patient.registration;

import java.util.Arrays;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The base of a lung, by its shape alone, so that one rule serves scans and simulations: triangles that look down (with
 * the lung drawn as tall as it is deep the outward normal, smoothed over neighbours, has a superior part below
 * {@value #MAX_NORMAL_Z}) and below which there is no more lung; of what hangs together the piece with the largest
 * area, and what it surrounds. The downward sides of hilum and fissures have lung below them or are pieces of their
 * own.
 */
public final class DiaphragmaticSurface {
    /**
     * Steeper parts belong to the costal or mediastinal surface: 33 degrees from the vertical; the heart undercuts
     * lungs by up to 30.
     */
    static final double MAX_NORMAL_Z = -0.55;

    private static final int SMOOTHINGS = 3;
    /** A ray starts this far below its triangle, mm: not at the surface that it leaves. */
    private static final double CLEAR_MM = 0.5;

    private DiaphragmaticSurface() {}

    /**
     * The facet as a surface of its own.
     *
     * @param lung one lung, closed, LPS, mm
     * @return without triangles if nothing looks down
     */
    public static TriangleMesh of(TriangleMesh lung) {
        return part(lung, triangleMask(lung), true);
    }

    /** All but the facet. */
    static TriangleMesh complement(TriangleMesh lung) {
        return part(lung, triangleMask(lung), false);
    }

    private static TriangleMesh part(TriangleMesh lung, boolean[] facet, boolean wanted) {
        int[] place = new int[lung.vertexCount()];
        Arrays.fill(place, -1);
        int[] corners = new int[lung.triangles().length];
        double[] p = new double[lung.positions().length];
        int vertices = 0;
        int count = 0;
        for (int t = 0; t < facet.length; t++) {
            for (int c = 3 * t; facet[t] == wanted && c < 3 * t + 3; c++) {
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

    /** Whether each vertex is a corner of the facet. */
    public static boolean[] vertexMask(TriangleMesh lung) {
        boolean[] facet = triangleMask(lung);
        boolean[] corner = new boolean[lung.vertexCount()];
        for (int c = 0; c < lung.triangles().length; c++) {
            corner[lung.triangles()[c]] |= facet[c / 3];
        }
        return corner;
    }

    /** Whether each triangle belongs to the facet. */
    static boolean[] triangleMask(TriangleMesh lung) {
        double[] normals = smoothed(lung);
        double outward = MeshMeasure.signedVolume(lung) < 0 ? -1 : 1;
        TriangleTree tree = new TriangleTree(lung);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int[] t = lung.triangles();
        boolean[] down = new boolean[lung.triangleCount()];
        for (int i = 0; i < down.length; i++) {
            double up = 0;
            double[] middle = new double[3];
            for (int c = 3 * i; c < 3 * i + 3; c++) {
                up += outward * normals[3 * t[c] + 2] / 3;
                middle[0] += lung.x(t[c]) / 3;
                middle[1] += lung.y(t[c]) / 3;
                middle[2] += lung.z(t[c]) / 3;
            }
            down[i] = up < MAX_NORMAL_Z
                    && tree.countAlongRay(middle[0], middle[1], middle[2] - CLEAR_MM, 0, 0, -1, hit) == 0;
        }
        MeshTopology topology = new MeshTopology(lung);
        keepLargest(lung, topology, down);
        // The recess is steep in places: what the facet surrounds belongs to it.
        invert(down);
        keepLargest(lung, topology, down);
        invert(down);
        return down;
    }

    private static void invert(boolean[] member) {
        for (int i = 0; i < member.length; i++) {
            member[i] = !member[i];
        }
    }

    /**
     * The lung as tall as it is deep: so the rule is the same for tall and flat lungs, and for voxels whose height is
     * stated wrongly.
     */
    private static TriangleMesh inProportion(TriangleMesh lung) {
        double[] box = lung.bounds();
        double[] p = lung.positions().clone();
        for (int z = 2; z < p.length; z += 3) {
            p[z] *= (box[4] - box[1]) / (box[5] - box[2]);
        }
        return lung.withPositions(p);
    }

    /** Unit vertex normals, each the mean of its neighbours' and its own a few times over. */
    private static double[] smoothed(TriangleMesh lung) {
        double[] normals = MeshMeasure.vertexNormals(inProportion(lung));
        int[] t = lung.triangles();
        for (int round = 0; round < SMOOTHINGS; round++) {
            double[] sum = new double[normals.length];
            for (int i = 0; i < t.length; i++) {
                int other = i % 3 == 2 ? t[i - 2] : t[i + 1];
                for (int k = 0; k < 3; k++) {
                    // An edge is met once from either side: each of its ends hears of the other.
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

    /** Of the pieces that hang together by edges leaves the one with the largest area. */
    private static void keepLargest(TriangleMesh lung, MeshTopology topology, boolean[] member) {
        int[] piece = new int[member.length];
        int[] queue = new int[member.length];
        double[] normals = new double[3];
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
                area += area(lung, queue[at], normals);
                for (int side = 0; side < 3; side++) {
                    int edge = topology.edgeOfSide()[3 * queue[at] + side];
                    int next = topology.faceCount(edge) == 1 ? -1 : topology.otherFace(edge, queue[at]);
                    if (next >= 0 && member[next] && piece[next] == 0) {
                        piece[next] = pieces;
                        queue[length++] = next;
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

    private static double area(TriangleMesh mesh, int triangle, double[] cross) {
        int a = mesh.triangles()[3 * triangle];
        int b = mesh.triangles()[3 * triangle + 1];
        int c = mesh.triangles()[3 * triangle + 2];
        double[] p = mesh.positions();
        double squared = 0;
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3;
            int j = (k + 2) % 3;
            cross[k] = (p[3 * b + i] - p[3 * a + i]) * (p[3 * c + j] - p[3 * a + j])
                    - (p[3 * b + j] - p[3 * a + j]) * (p[3 * c + i] - p[3 * a + i]);
            squared += cross[k] * cross[k];
        }
        return 0.5 * Math.sqrt(squared);
    }
}
