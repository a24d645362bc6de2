package org.phrenic.model.organ;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * Stiffness of the struts across the thickness of a sheet, and what they carry along it.
 *
 * <p>Oblique struts resist shear between the faces. On cells of edge e and thickness t struts of stiffness k resist it
 * by k / (t² + e²) per unit of area, so k is in proportion to t² + e², and shear does not depend on the mesh: for a
 * sheet of E h = 300 N/m and 3 mm the shear modulus is 5 kPa.
 *
 * <p>They also carry part of the stiffness along the sheet. Under a strain that is equal in all directions a spring of
 * length l, of which s lies along the sheet, stores energy in proportion to k (s² / l)². Edges carry the rest.
 */
final class SheetStruts {
    /** Stiffness of a strut relative to that of an edge of muscle, on cells of {@value #EDGE_MM} mm. */
    private static final double RELATIVE_STIFFNESS = 0.5;

    /** Mean edge length of the virtual man's sheet at medium resolution, mm. */
    private static final double EDGE_MM = 5.65;

    /** Limit of t² + e² relative to that of these cells; on coarser ones struts would shorten the stable step. */
    private static final double LARGEST_CELL = 2;

    /** Largest share of the stiffness along the sheet that struts count for. */
    private static final double MOST = 0.5;

    private final TriangleMesh sheet;
    private final List<OpposingVertices.Pair> pairs;
    private final double[] normals;
    private final double[] thickness;
    /** Stiffness of a strut at each vertex, N/m. */
    private final double[] stiffness;

    /**
     * @param pairs ends of the struts
     * @param edgeStiffness stiffness of an edge between two triangles of muscle, N/m
     */
    SheetStruts(Diaphragm diaphragm, List<OpposingVertices.Pair> pairs, double edgeStiffness) {
        this.pairs = pairs;
        sheet = diaphragm.sheet();
        normals = MeshMeasure.vertexNormals(sheet);
        thickness = thicknesses();
        double[] areas = MeshMeasure.vertexAreas(sheet);
        stiffness = new double[areas.length];
        for (int v = 0; v < areas.length; v++) {
            double across = thickness[v] * thickness[v];
            double edge = areas[v] / (Math.sqrt(3) / 2);
            double cell = Math.min(LARGEST_CELL, (across + edge) / (across + EDGE_MM * EDGE_MM));
            stiffness[v] = RELATIVE_STIFFNESS * edgeStiffness * cell;
        }
    }

    private double[] thicknesses() {
        double[] nearest = new double[sheet.vertexCount()];
        double[] across = new double[sheet.vertexCount()];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (OpposingVertices.Pair pair : pairs) {
            double length = MeshMeasure.distance(sheet, pair.a(), pair.b());
            for (int end : new int[] {pair.a(), pair.b()}) {
                if (length < nearest[end]) {
                    nearest[end] = length;
                    across[end] = across(pair);
                }
            }
        }
        return across;
    }

    /** Length of a strut along the mean of the normals at its ends, mm; where the sheet bends, the mean follows it. */
    private double across(OpposingVertices.Pair strut) {
        double[] p = sheet.positions();
        double sum = 0;
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double normal = normals[3 * strut.a() + axis] - normals[3 * strut.b() + axis];
            sum += (p[3 * strut.b() + axis] - p[3 * strut.a() + axis]) * normal;
            squared += normal * normal;
        }
        return squared > 0 ? Math.abs(sum) / Math.sqrt(squared) : 0;
    }

    /** Thickness of the sheet at a vertex, mm: along its normal to the nearest opposing vertex; 0 without one. */
    double thickness(int vertex) {
        return thickness[vertex];
    }

    /** Stiffness of a strut, N/m. */
    double stiffness(OpposingVertices.Pair strut) {
        return 0.5 * (stiffness[strut.a()] + stiffness[strut.b()]);
    }

    /**
     * Share of the stiffness along the sheet that struts carry at each vertex, 0 to 0.5.
     *
     * @param edgeStiffness stiffness of each edge of the sheet if edges alone carried it, N/m
     */
    double[] carriedShares(MeshTopology topology, double[] edgeStiffness) {
        double[] byEdges = new double[sheet.vertexCount()];
        double[] byStruts = new double[sheet.vertexCount()];
        for (int e = 0; e < edgeStiffness.length; e++) {
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            double length = MeshMeasure.distance(sheet, a, b);
            byEdges[a] += edgeStiffness[e] * length * length;
            byEdges[b] += edgeStiffness[e] * length * length;
        }
        for (OpposingVertices.Pair pair : pairs) {
            double length = MeshMeasure.distance(sheet, pair.a(), pair.b());
            double across = across(pair);
            double along = (length * length - across * across) / length;
            byStruts[pair.a()] += stiffness(pair) * along * along;
            byStruts[pair.b()] += stiffness(pair) * along * along;
        }
        double[] share = new double[byEdges.length];
        for (int v = 0; v < share.length; v++) {
            share[v] = byEdges[v] > 0 ? Math.min(MOST, byStruts[v] / byEdges[v]) : 0;
        }
        return share;
    }
}
