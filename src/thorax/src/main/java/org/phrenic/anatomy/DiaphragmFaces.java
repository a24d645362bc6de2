package org.phrenic.anatomy;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.engine.math.DisjointSets;
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
 *
 * <p>Where a dome is flat or hollow toward the thorax, as in a scan at full inspiration, that centre misleads. Vertices
 * joined by edges across which the normal turns little form patches, and the two largest are the insides of the faces.
 * The integral of the upward normal over a face is the area inside the projected border, so the patch with the larger
 * one is thoracic, whatever its shape. If the votes contradict the patches at more than {@value #MISREAD_SHARE} of all
 * vertices, not counting those within {@value #BORDER_EDGES} edges of a patch's border, the patches decide, and
 * vertices between them take the face of the neighbour with the most similar normal. If there are fewer, only the
 * connected regions of them that reach beyond those edges with more than one vertex take the face of their patch, such
 * as a steep step between the domes beside the xiphoid.
 *
 * <p>A face is connected. A connected component of one face of fewer than {@value #ISLAND_SHARE} of all vertices, such
 * as a dimple that votes and patches misread, takes the other face.
 */
public final class DiaphragmFaces {
    /**
     * Centre of the concavity as fractions of the sheet's bounding box: a quarter of the width to each side, slightly
     * below half the height.
     */
    private static final double LATERAL_SHARE = 0.25;

    private static final double HEIGHT_SHARE = 0.45;
    private static final int VOTING_ROUNDS = 12;
    /** Edges from the border of a patch within which the votes decide: a vertex there may belong to either face. */
    private static final int BORDER_EDGES = 3;

    private static final double MISREAD_SHARE = 0.002;
    /** Least share of the vertices in the smaller of the two largest patches, if these are the two faces. */
    private static final double FACE_SHARE = 0.4;
    /** Least share of the vertices in a connected component of a face. */
    private static final double ISLAND_SHARE = 0.01;
    /** Cosines of the angle between neighbouring normals within a patch, tried in this order. */
    private static final double[] PATCH_COSINES = {0.5, 0.6, 0.7, 0.8, 0.9, 0.95};

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
        int[] edges = topology.edges();
        correct(sheet, edges, normals);
        joinIslands(thoracic, edges);
        onBorder = new boolean[n];
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
            double agree = OpposingVertices.dot(normals, a, b);
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

    private void correct(TriangleMesh sheet, int[] edges, double[] normals) {
        for (double least : PATCH_COSINES) {
            int[] patch = patches(edges, normals, least);
            int[] size = new int[patch.length];
            IntStream.of(patch).forEach(root -> size[root]++);
            int first = largest(size, -1);
            int second = largest(size, first);
            if (size[second] < FACE_SHARE * patch.length) {
                continue;
            }
            boolean up = upward(sheet, patch, first) > upward(sheet, patch, second);
            int top = up ? first : second;
            int bottom = up ? second : first;
            boolean[] near = nearBorder(edges, patch);
            long misread = IntStream.range(0, patch.length)
                    .filter(i -> !near[i] && patch[i] == (thoracic[i] ? bottom : top))
                    .count();
            if (misread > MISREAD_SHARE * patch.length) {
                Arrays.setAll(patch, i -> patch[i] == top ? 1 : patch[i] == bottom ? 0 : -1);
                fill(patch, edges, normals);
            } else {
                correctRegions(thoracic, edges, near, i -> patch[i] == (thoracic[i] ? bottom : top));
            }
            return;
        }
    }

    /**
     * Gives connected regions of misread vertices to the other face if two or more of a region are not near the border
     * of the patches, given the two ends of each edge.
     */
    static void correctRegions(boolean[] thoracic, int[] edges, boolean[] near, IntPredicate misread) {
        boolean[] wrong = new boolean[near.length];
        for (int i = 0; i < near.length; i++) {
            wrong[i] = misread.test(i);
        }
        int[] region = components(near.length, edges, (a, b) -> wrong[a] && wrong[b]);
        int[] beyond = new int[near.length];
        for (int i = 0; i < near.length; i++) {
            beyond[region[i]] += wrong[i] && !near[i] ? 1 : 0;
        }
        for (int i = 0; i < near.length; i++) {
            thoracic[i] ^= beyond[region[i]] > 1;
        }
    }

    /** The vertices at most {@value #BORDER_EDGES} edges from a vertex of another patch. */
    private static boolean[] nearBorder(int[] edges, int[] patch) {
        boolean[] near = new boolean[patch.length];
        for (int round = 0; round < BORDER_EDGES; round++) {
            boolean[] next = near.clone();
            for (int e = 0; e < edges.length; e += 2) {
                int a = edges[e];
                int b = edges[e + 1];
                boolean crosses = patch[a] != patch[b];
                next[a] |= crosses || near[b];
                next[b] |= crosses || near[a];
            }
            near = next;
        }
        return near;
    }

    /** Twice the integral of the upward normal over the triangles of a patch, mm². */
    private static double upward(TriangleMesh sheet, int[] patch, int chosen) {
        double[] cross = new double[3];
        int[] corners = sheet.triangles();
        double sum = 0;
        for (int t = 0; t < corners.length; t += 3) {
            if (patch[corners[t]] == chosen && patch[corners[t + 1]] == chosen && patch[corners[t + 2]] == chosen) {
                MeshMeasure.triangleCrossProduct(sheet, t / 3, cross);
                sum += cross[2];
            }
        }
        return sum;
    }

    /** For each vertex the lowest vertex of its patch. */
    private static int[] patches(int[] edges, double[] normals, double least) {
        return components(normals.length / 3, edges, (a, b) -> OpposingVertices.dot(normals, a, b) > least);
    }

    /** Whether an edge joins its two vertices. */
    private interface Join {
        boolean joins(int a, int b);
    }

    /** For each of n vertices the lowest vertex that edges of a kind connect it with. */
    private static int[] components(int n, int[] edges, Join join) {
        int[] sets = DisjointSets.singletons(n);
        for (int e = 0; e < edges.length; e += 2) {
            if (join.joins(edges[e], edges[e + 1])) {
                DisjointSets.unionToLower(sets, edges[e], edges[e + 1]);
            }
        }
        int[] lowest = new int[n];
        Arrays.setAll(lowest, i -> DisjointSets.find(sets, i));
        return lowest;
    }

    private static int largest(int[] size, int except) {
        int most = except == 0 ? 1 : 0;
        for (int i = 0; i < size.length; i++) {
            most = i != except && size[i] > size[most] ? i : most;
        }
        return most;
    }

    /**
     * Takes the faces from {@code face} (1 thoracic, 0 abdominal, -1 unknown); in each round an unknown vertex takes
     * that of its known neighbour with the most similar normal.
     */
    private void fill(int[] face, int[] edges, double[] normals) {
        boolean changed = true;
        while (changed) {
            changed = false;
            double[] best = new double[face.length];
            Arrays.fill(best, -2);
            int[] next = face.clone();
            for (int side = 0; side < edges.length; side++) {
                int from = edges[side];
                int to = edges[side ^ 1];
                double agree = OpposingVertices.dot(normals, from, to);
                if (face[to] < 0 && face[from] >= 0 && agree > best[to]) {
                    best[to] = agree;
                    next[to] = face[from];
                    changed = true;
                }
            }
            System.arraycopy(next, 0, face, 0, face.length);
        }
        for (int i = 0; i < face.length; i++) {
            thoracic[i] = face[i] < 0 ? thoracic[i] : face[i] == 1;
        }
    }

    /** Gives small connected components of one face to the other, given the two ends of each edge. */
    static void joinIslands(boolean[] thoracic, int[] edges) {
        int n = thoracic.length;
        int[] face = components(n, edges, (a, b) -> thoracic[a] == thoracic[b]);
        int[] size = new int[n];
        IntStream.of(face).forEach(lowest -> size[lowest]++);
        for (int i = 0; i < n; i++) {
            thoracic[i] ^= size[face[i]] < ISLAND_SHARE * n;
        }
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
