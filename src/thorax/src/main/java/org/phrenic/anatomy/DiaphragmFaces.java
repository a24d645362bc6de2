package org.phrenic.anatomy;

import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * The two faces of a closed diaphragm sheet: the thoracic face (toward lungs, heart and chest wall), the abdominal face
 * (toward liver, stomach, spleen) and the border between them.
 *
 * <p>A vertex is thoracic if its outward normal points away from the centre of the concavity of its hemidiaphragm. The
 * flanks of the groove for the spine and the crura are nearly parallel to that direction, so a few rounds of voting
 * among neighbours with similar normals decide the sign.
 */
public final class DiaphragmFaces {
    /**
     * Centre of the concavity as fractions of the sheet's bounding box: a quarter of the width to each side, slightly
     * below half the height.
     */
    private static final double LATERAL_SHARE = 0.25;

    private static final double HEIGHT_SHARE = 0.45;
    private static final int VOTING_ROUNDS = 12;

    private final boolean[] thoracic;
    private final boolean[] onBorder;

    /** Classifies the vertices of a closed sheet in LPS with outward normals. */
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
            // Normals turn over at the rim, where a neighbour's vote is meaningless or has the opposite sign.
            double weight = agree > 0.5 ? agree : 0;
            next[a] += 0.5 * weight * score[b];
            next[b] += 0.5 * weight * score[a];
        }
        for (int i = 0; i < next.length; i++) {
            next[i] = Math.max(-1, Math.min(1, next[i]));
        }
        return next;
    }

    /** True if a vertex lies on the thoracic face. */
    public boolean isThoracic(int vertex) {
        return thoracic[vertex];
    }

    /**
     * True if a vertex has a neighbour on the other face. These vertices form the border of the sheet and of its
     * openings.
     */
    public boolean isBorder(int vertex) {
        return onBorder[vertex];
    }

    public int vertexCount() {
        return thoracic.length;
    }
}
