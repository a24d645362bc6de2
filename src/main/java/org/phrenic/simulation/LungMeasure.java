package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.BlendedMotion;
import org.phrenic.anatomy.BoneWeights;
import org.phrenic.anatomy.Structure;
import org.phrenic.engine.force.FallOff;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.TriangleMesh;

/**
 * Where the lungs are and how much air they hold. Stepped lungs are read off the nodes; embedded ones are carried: at the base by the diaphragm, far from it by the chest wall, blended between the
 * two. Volumes of open lobes are those with their open borders (fissures) capped.
 */
final class LungMeasure {
    private static final double FADE_MM = 90;

    private final List<Structure> structures;
    private final int[] firsts;
    private final List<List<int[]>> loops = new ArrayList<>();
    private final BlendedMotion[] walls;
    private final int[][] carrier;
    private final double[][] carried;

    LungMeasure(Scene scene) {
        boolean stepped = scene.lungs().isPresent();
        structures = stepped ? scene.lungs().get().structures : scene.embeddedLungs();
        int n = structures.size();
        firsts = stepped
                ? scene.lungs().get().firsts.stream().mapToInt(Integer::intValue).toArray()
                : null;
        walls = new BlendedMotion[n];
        carrier = new int[n][];
        carried = new double[n][];
        BoneWeights bones = stepped || n == 0 ? null : BoneWeights.of(scene.thorax(), scene.pose().cage());
        for (int s = 0; s < n; s++) {
            TriangleMesh mesh = structures.get(s).mesh();
            loops.add(new MeshTopology(mesh).boundaryLoops());
            if (!stepped) {
                walls[s] = new BlendedMotion(scene.pose(), mesh.positions(), bones.at(mesh.positions()));
                embed(scene, s, mesh);
            }
        }
    }

    private void embed(Scene scene, int s, TriangleMesh mesh) {
        NearestVertex thoracic = LungPart.thoracicFace(scene.diaphragm().diaphragm);
        carrier[s] = new int[mesh.vertexCount()];
        carried[s] = new double[mesh.vertexCount()];
        for (int i = 0; i < mesh.vertexCount(); i++) {
            carrier[s][i] = scene.diaphragm().first + thoracic.find(mesh.x(i), mesh.y(i), mesh.z(i));
            carried[s][i] = FallOff.at(thoracic.distance(), FADE_MM);
        }
    }

    List<Structure> structures() {
        return structures;
    }

    /** Vertices of a lung as the scene stands, mm. */
    double[] positions(int s, double time, double[] rest, double[] now) {
        int length = structures.get(s).mesh().positions().length;
        if (firsts != null) {
            return Arrays.copyOfRange(now, 3 * firsts[s], 3 * firsts[s] + length);
        }
        double[] p = new double[length];
        walls[s].at(time, p, new double[length]);
        double[] start = structures.get(s).mesh().positions();
        for (int i = 0; i < length; i++) {
            int node = 3 * carrier[s][i / 3] + i % 3;
            double w = carried[s][i / 3];
            p[i] = w * (start[i] + now[node] - rest[node]) + (1 - w) * p[i];
        }
        return p;
    }

    /** Volume of all lungs, ml. */
    double volume(double time, double[] rest, double[] now) {
        double sum = 0;
        for (int s = 0; s < structures.size(); s++) {
            TriangleMesh moved = structures.get(s).mesh().withPositions(positions(s, time, rest, now));
            sum += MeshMeasure.cappedVolume(moved, loops.get(s)) / 1000;
        }
        return sum;
    }
}
