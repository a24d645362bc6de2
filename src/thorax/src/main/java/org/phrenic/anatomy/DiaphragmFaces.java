package org.phrenic.anatomy;

import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * The two faces of a closed double-layered diaphragm: which vertex lies on the thoracic face (toward lungs, heart and
 * chest wall) and which on the abdominal one (toward liver, stomach, spleen), and where the two meet.
 *
 * <p>An outward normal that points away from the middle of the hemidiaphragm's hollow is thoracic. That sign is settled
 * by a few rounds of voting among neighbours whose normals agree, for the flanks of the spine's groove and the crura
 * are nearly parallel to it.
 */
public final class DiaphragmFaces {
    /**
     * The hollow's middle, as shares of the sheet's box: a quarter of the width to each side, a little below half
     * height.
     */
    private static final double LATERAL_SHARE = 0.25;

    private static final double HEIGHT_SHARE = 0.45;
    private static final int VOTING_ROUNDS = 12;

    private final boolean[] thoracic;
    private final boolean[] onBorder;

    /** Tells the faces of a closed sheet in LPS, normals outward. */
    public DiaphragmFaces(TriangleMesh sheet, MeshTopology topology) {
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] box = sheet.bounds();
        int n = sheet.vertexCount();
        double middleX = 0.5 * (box[0] + box[3]);
        double middleY = 0.5 * (box[1] + box[4]);
        double middleZ = box[2] + HEIGHT_SHARE * (box[5] - box[2]);
        double[] score = new double[n];
        for (int i = 0; i < n; i++) {
            double side = sheet.x(i) < middleX ? -1 : 1;
            double dx = sheet.x(i) - middleX - side * LATERAL_SHARE * (box[3] - box[0]);
            double dy = sheet.y(i) - middleY;
            double dz = sheet.z(i) - middleZ;
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            score[i] = (normals[3 * i] * dx + normals[3 * i + 1] * dy + normals[3 * i + 2] * dz) / length;
        }
        for (int round = 0; round < VOTING_ROUNDS; round++) {
            score = vote(topology, normals, score);
        }
        thoracic = new boolean[n];
        for (int i = 0; i < n; i++) {
            thoracic[i] = score[i] > 0;
        }
        onBorder = new boolean[n];
        int[] edges = topology.edges();
        for (int e = 0; e < edges.length; e += 2) {
            if (thoracic[edges[e]] != thoracic[edges[e + 1]]) {
                onBorder[edges[e]] = true;
                onBorder[edges[e + 1]] = true;
            }
        }
    }

    private static double[] vote(MeshTopology topology, double[] normals, double[] score) {
        double[] next = score.clone();
        int[] edges = topology.edges();
        for (int e = 0; e < edges.length; e += 2) {
            int a = edges[e];
            int b = edges[e + 1];
            double agree = normals[3 * a] * normals[3 * b]
                    + normals[3 * a + 1] * normals[3 * b + 1]
                    + normals[3 * a + 2] * normals[3 * b + 2];
            // Round the rim the normal turns over: there a neighbour says nothing, or the opposite.
            double weight = agree > 0.5 ? agree : 0;
            next[a] += 0.5 * weight * score[b];
            next[b] += 0.5 * weight * score[a];
        }
        for (int i = 0; i < next.length; i++) {
            next[i] = Math.max(-1, Math.min(1, next[i]));
        }
        return next;
    }

    /** Whether a vertex lies on the thoracic face. */
    public boolean isThoracic(int vertex) {
        return thoracic[vertex];
    }

    /**
     * Whether a vertex has a neighbour on the other face: the free or inserted border of the sheet, openings included.
     */
    public boolean isBorder(int vertex) {
        return onBorder[vertex];
    }

    public int vertexCount() {
        return thoracic.length;
    }
}
