package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The lungs as part of a scene: springs along their surface; at the base springs to the thoracic face of the diaphragm,
 * on which they slide ({@link LungBaseMotion}); where they lie against the ribs they slide on the pleura and cannot
 * leave it, and attachments of low elasticity to the chest wall, which fade toward the base so that the lung can follow
 * the dome down, keep them from sliding off.
 *
 * <p>{@code wall} is null in scenes without a chest wall (the paper's): then the attachments alone hold the lungs.
 */
public final class LungPart {
    /** A lung's vertex nearer than this to the diaphragm belongs to the base. */
    private static final double BASE_MM = 9;

    /** Over this distance from the base the attachment to the chest wall comes to its full strength. */
    private static final double FADE_MM = 80;

    /** A vertex farther from every bone faces the mediastinum, which holds it to nothing. */
    private static final double COSTAL_MM = 25;

    /** A vertex this near to the wall that looks outward lies on the pleura. */
    private static final double PLEURAL_MM = 8;

    private static final double LATERAL = 0.5;
    /** What faces upward more than this is the cupola, which the first rib and its fascia hold. */
    private static final double UPWARD = 0.5;

    /**
     * Against wrinkling: the tissue behind the surface tethers every vertex to its place a little, as a share of an
     * edge's stiffness a node ({@link TissueLaw#beddingFactors}).
     */
    private static final double PARENCHYMA = 0.1;

    private static final double COSTAL_SHARE = 0.3;
    private static final double BASE_LINK = 4;
    /**
     * Where the base slides its springs are softer: they follow what moves by itself and need not hold against
     * anything.
     */
    private static final double SLIDING_BASE_LINK = 2;

    public final List<Structure> structures;
    public final List<Integer> firstNodes = new ArrayList<>();
    /** What lies on the diaphragm; empty without a chest wall, where springs between nodes hold the base. */
    public final LungBaseMotion.BaseSprings baseSprings =
            new LungBaseMotion.BaseSprings(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());

    private final List<Integer> pleuralNodes = new ArrayList<>();
    /**
     * Nodes of the mediastinal surface, the stiffness that holds each to its place, and the outward normal, weighted,
     * three numbers each; right lung, then left.
     */
    private final List<List<Integer>> mediastinal = List.of(new ArrayList<>(), new ArrayList<>());

    private final List<List<Double>> outwardLoad = List.of(new ArrayList<>(), new ArrayList<>());

    /**
     * @param wall null where there is none
     * @param stiffness of the lungs as a multiple of relaxed muscle's
     */
    public LungPart(
            MassSpringBuilder parts,
            List<Structure> lungs,
            ThoracicFace face,
            SkinningWeights bones,
            MovingChestWall wall,
            TissueLaw law,
            double stiffness) {
        structures = lungs;
        TriangleTree.Hit onFace = new TriangleTree.Hit();
        double edge = law.edgeStiffness(2, stiffness);
        for (Structure s : lungs) {
            TriangleMesh mesh = s.mesh();
            int first = parts.addNodes(mesh, law.masses(mesh, stiffness));
            firstNodes.add(first);
            law.addEdges(parts.passiveSprings, mesh, first, stiffness);
            double[] normals = MeshMeasure.vertexNormals(mesh);
            double[] bed = law.beddingFactors(mesh);
            double[] toBone = bones.distances(mesh.positions());
            for (int i = 0; i < mesh.vertexCount(); i++) {
                double distance = face.closest(mesh.x(i), mesh.y(i), mesh.z(i), FADE_MM, onFace)
                        ? Math.sqrt(onFace.distanceSquared)
                        : FADE_MM;
                boolean costal = wall != null
                        && wall.depth(mesh.x(i), mesh.y(i), mesh.z(i)) < PLEURAL_MM
                        && wall.outwardComponent(mesh.x(i), mesh.y(i), normals[3 * i], normals[3 * i + 1]) > LATERAL;
                if (costal) {
                    pleuralNodes.add(first + i);
                }
                if (distance < BASE_MM) {
                    baseSprings.nodes().add(first + i);
                    baseSprings.nearest().add(face.nearestVertex(onFace));
                    baseSprings.stiffness().add((wall == null ? BASE_LINK : SLIDING_BASE_LINK) * edge * bed[i]);
                } else {
                    double costalShare = toBone[i] < COSTAL_MM ? COSTAL_SHARE * (1 - FallOff.at(distance, FADE_MM)) : 0;
                    double held = edge * bed[i] * Math.max(PARENCHYMA, costalShare);
                    parts.attachToBone(first + i, held);
                    double facing = Math.max(0, Math.min(1, 1 - normals[3 * i + 2] / UPWARD));
                    if (!costal && costalShare <= PARENCHYMA && facing > 0) {
                        int side = s.side() == Side.LEFT ? 1 : 0;
                        mediastinal.get(side).add(first + i);
                        for (int axis = 0; axis < 3; axis++) {
                            outwardLoad.get(side).add(facing * held * normals[3 * i + axis]);
                        }
                    }
                }
            }
        }
        TieSprings.connect(parts, lungs, firstNodes, edge);
    }

    /**
     * What pushes the mediastinal surface of a lung out by 1 mm against what tethers it: three numbers a node of the
     * scene, mN.
     */
    public double[] outwardLoad(boolean left, int nodes) {
        double[] load = new double[3 * nodes];
        int side = left ? 1 : 0;
        for (int i = 0; i < outwardLoad.get(side).size(); i++) {
            load[3 * mediastinal.get(side).get(i / 3) + i % 3] =
                    outwardLoad.get(side).get(i);
        }
        return load;
    }

    /** Nodes that slide on the chest wall and cannot leave it. */
    public int[] pleuralNodes() {
        return pleuralNodes.stream().mapToInt(Integer::intValue).toArray();
    }
}
