package org.phrenic.simulation.observe;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.NearestVertex;

/**
 * Position and inspired volume of the lungs. Positions of mass-spring lungs are read from the nodes. Embedded lungs
 * follow the diaphragm at the base and the chest wall far from it, with a blend in between.
 */
public final class LungMeasure {
    private static final double FADE_MM = 90;

    private final List<Structure> structures;
    private final int[] firsts;
    private final LinearBlendSkinning[] walls;
    private final int[][] diaphragmNode;
    private final double[][] diaphragmShare;
    private final double[][] position;
    private final double[][] velocity;
    /** Vertex positions of each lung at rest. */
    private final double[][] start;

    public LungMeasure(Scene scene) {
        boolean stepped = scene.lungs().isPresent();
        structures = stepped ? scene.lungs().get().structures : scene.embeddedLungs();
        int n = structures.size();
        firsts = stepped
                ? scene.lungs().get().firstNodes.stream()
                        .mapToInt(Integer::intValue)
                        .toArray()
                : null;
        walls = new LinearBlendSkinning[n];
        diaphragmNode = new int[n][];
        diaphragmShare = new double[n][];
        position = new double[n][];
        velocity = new double[n][];
        SkinningWeights bones = stepped || n == 0
                ? null
                : SkinningWeights.of(scene.thorax(), scene.pose().cage());
        for (int s = 0; s < n; s++) {
            TriangleMesh mesh = structures.get(s).mesh();
            position[s] = new double[mesh.positions().length];
            if (!stepped) {
                velocity[s] = new double[mesh.positions().length];
                double[] p = mesh.positions();
                walls[s] = new LinearBlendSkinning(
                        scene.pose(), p, bones.weightsAt(p), scene.system().workers());
                embed(scene, s, mesh);
            }
        }
        start = new double[n][];
        for (int s = 0; s < n; s++) {
            start[s] = positions(s, 0, scene.restPositions(), scene.restPositions())
                    .clone();
        }
    }

    private LungMeasure(LungMeasure like, RibCagePose pose) {
        structures = like.structures;
        firsts = like.firsts;
        walls = Arrays.stream(like.walls)
                .map(wall -> wall == null ? null : wall.after(pose))
                .toArray(LinearBlendSkinning[]::new);
        diaphragmNode = like.diaphragmNode;
        diaphragmShare = like.diaphragmShare;
        position = Arrays.stream(like.position).map(double[]::clone).toArray(double[][]::new);
        velocity = Arrays.stream(like.velocity)
                .map(v -> v == null ? null : v.clone())
                .toArray(double[][]::new);
        start = like.start;
    }

    /** The same lungs after another pose of the rib cage, with working memory of their own. */
    public LungMeasure after(RibCagePose pose) {
        return new LungMeasure(this, pose);
    }

    private void embed(Scene scene, int s, TriangleMesh mesh) {
        Diaphragm sheet = scene.diaphragm().diaphragm;
        NearestVertex thoracic = new NearestVertex(sheet.sheet(), sheet::isThoracic);
        diaphragmNode[s] = new int[mesh.vertexCount()];
        diaphragmShare[s] = new double[mesh.vertexCount()];
        for (int i = 0; i < mesh.vertexCount(); i++) {
            diaphragmNode[s][i] = scene.diaphragm().firstNode + thoracic.find(mesh.x(i), mesh.y(i), mesh.z(i));
            diaphragmShare[s][i] = FallOff.at(thoracic.distance(), FADE_MM);
        }
    }

    public List<Structure> structures() {
        return structures;
    }

    /** Current vertex positions of a lung, mm; valid until the next call for the same lung. */
    public double[] positions(int s, double time, double[] rest, double[] now) {
        double[] p = position[s];
        int length = p.length;
        if (firsts != null) {
            System.arraycopy(now, 3 * firsts[s], p, 0, length);
            return p;
        }
        walls[s].at(time, p, velocity[s]);
        double[] vertices = structures.get(s).mesh().positions();
        for (int i = 0; i < length; i++) {
            int node = 3 * diaphragmNode[s][i / 3] + i % 3;
            double w = diaphragmShare[s][i / 3];
            p[i] = w * (vertices[i] + now[node] - rest[node]) + (1 - w) * p[i];
        }
        return p;
    }

    /** Updates the positions of all lungs to the current state. */
    public void update(double time, double[] rest, double[] now) {
        for (int s = 0; s < position.length; s++) {
            positions(s, time, rest, now);
        }
    }

    /**
     * Volume inspired since rest at the last update, ml: the volume swept by the outer surface of all lobes, ∫ u·n dA.
     * Lobes may be open at the fissures; the volumes swept by two adjacent lobes cancel there.
     */
    public double volumeChange() {
        double sum = 0;
        for (int s = 0; s < structures.size(); s++) {
            sum += SweptVolume.of(structures.get(s).mesh().triangles(), start[s], position[s]) / 1000;
        }
        return sum;
    }
}
