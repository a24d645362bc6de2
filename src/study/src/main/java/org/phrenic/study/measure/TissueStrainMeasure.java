package org.phrenic.study.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Deformation of the diaphragm's muscle and tendon since rest: rms relative change of edge lengths, per cent. An edge
 * belongs to the tendon if both its ends do. For the tendon also the rms distance of the vertices from the best-fit
 * rigid motion of their connected piece, mm.
 */
final class TissueStrainMeasure implements SceneMeasure {
    static final List<String> NAMES =
            List.of("muscle_edge_change_percent", "tendon_edge_change_percent", "tendon_bent_mm");

    /** Smaller pieces are isolated vertices and are ignored. */
    private static final int MIN_PIECE_VERTICES = 10;

    private final int sheet;
    private final int[] edges;
    private final double[] restLength;
    private final List<int[]> tendonPieces;

    TissueStrainMeasure(SceneGeometry view) {
        sheet = view.diaphragm();
        TriangleMesh rest = view.surface(sheet).rest();
        edges = new MeshTopology(rest).edges();
        restLength = new double[edges.length / 2];
        Arrays.setAll(restLength, e -> length(rest.positions(), e));
        tendonPieces = tendonPieces(view.surface(sheet).tendon());
    }

    private double length(double[] p, int edge) {
        int a = 3 * edges[2 * edge];
        int b = 3 * edges[2 * edge + 1];
        return Math.sqrt((p[a] - p[b]) * (p[a] - p[b])
                + (p[a + 1] - p[b + 1]) * (p[a + 1] - p[b + 1])
                + (p[a + 2] - p[b + 2]) * (p[a + 2] - p[b + 2]));
    }

    /** Vertices of each connected tendon piece. */
    private List<int[]> tendonPieces(boolean[] tendon) {
        int[] head = DisjointSets.singletons(tendon.length);
        for (int e = 0; e < edges.length; e += 2) {
            if (tendon[edges[e]] && tendon[edges[e + 1]]) {
                head[DisjointSets.find(head, edges[e])] = DisjointSets.find(head, edges[e + 1]);
            }
        }
        List<List<Integer>> found = new ArrayList<>();
        int[] pieceOf = new int[tendon.length];
        for (int i = 0; i < tendon.length; i++) {
            if (tendon[i]) {
                int h = DisjointSets.find(head, i);
                if (pieceOf[h] == 0) {
                    found.add(new ArrayList<>());
                    pieceOf[h] = found.size();
                }
                found.get(pieceOf[h] - 1).add(i);
            }
        }
        return found.stream()
                .filter(piece -> piece.size() >= MIN_PIECE_VERTICES)
                .map(piece -> piece.stream().mapToInt(Integer::intValue).toArray())
                .toList();
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        measureSheet(view.surface(sheet), view.positions(sheet), values);
    }

    /** Measures a sheet from its rest shape and its current positions, mm. */
    void measureSheet(Surface s, double[] now, Map<String, Double> values) {
        double[] sum = new double[2];
        int[] count = new int[2];
        for (int e = 0; e < restLength.length; e++) {
            int tissue = s.tendon()[edges[2 * e]] && s.tendon()[edges[2 * e + 1]] ? 1 : 0;
            double change = length(now, e) / restLength[e] - 1;
            sum[tissue] += change * change;
            count[tissue]++;
        }
        values.put("muscle_edge_change_percent", 100 * Math.sqrt(sum[0] / count[0]));
        if (count[1] > 0) {
            values.put("tendon_edge_change_percent", 100 * Math.sqrt(sum[1] / count[1]));
            values.put("tendon_bent_mm", tendonDeviation(s.rest().positions(), now));
        }
    }

    private double tendonDeviation(double[] rest, double[] now) {
        double sum = 0;
        int count = 0;
        for (int[] piece : tendonPieces) {
            double[] from = Vectors.gather(rest, piece);
            double[] to = Vectors.gather(now, piece);
            double rms = RigidMotion.fit(from, to).rms(from, to);
            sum += rms * rms * piece.length;
            count += piece.length;
        }
        return Math.sqrt(sum / count);
    }
}
