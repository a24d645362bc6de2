package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The lungs as nodes and springs of a scene: springs along their surface, and springs from the base to the thoracic
 * face of the diaphragm, on which the base slides ({@link LungBaseMotion}).
 *
 * <p>The costal surface slides on the pleura and cannot leave it. Weak attachments to the chest wall stop it from
 * sliding off; they fade toward the base so that the lung can follow the dome down.
 *
 * <p>A lung that nowhere comes near the diaphragm, for fluid or a lobe that is not in the body is between, has a base
 * all the same: what of it looks down follows the diaphragm at the distance of rest, as the fluid does not expand.
 *
 * <p>{@code wall} is null in scenes without a chest wall, as in the paper. Then the base follows the diaphragm's nodes,
 * and only the attachments hold the other nodes.
 */
public final class LungPart {
    /** A lung vertex nearer than this to the diaphragm belongs to the base. */
    private static final double BASE_MM = 9;

    /** Distance from the base over which the attachment to the chest wall rises to full strength. */
    private static final double FADE_MM = 80;

    /** A vertex farther than this from every bone faces the mediastinum and has no attachment. */
    private static final double COSTAL_MM = 25;

    /** A vertex within this distance of the wall whose normal points outward lies on the pleura. */
    private static final double PLEURAL_MM = 8;

    private static final double LATERAL = 0.5;
    /**
     * A vertex whose normal has a larger upward component belongs to the cupola, which the first rib and its fascia
     * hold.
     */
    private static final double UPWARD = 0.5;

    /**
     * Tether of every vertex to its rest position, which stands for the tissue behind the surface and prevents
     * wrinkling. Share of an edge's stiffness per node ({@link TissueLaw#beddingFactors}).
     */
    private static final double PARENCHYMA = 0.1;

    /**
     * A lung of which a smaller share of vertices lies on the diaphragm is parted from it; others have 0.1 and more.
     */
    private static final double PARTED_SHARE = 0.02;
    /** Farthest base of a parted lung from the diaphragm, mm, and greatest depth of such a base. */
    private static final double PARTED_REACH_MM = 200;

    private static final double PARTED_BASE_MM = 40;
    /** Upward component of the normals of a base, at most. */
    private static final double DOWNWARD = -0.5;

    private static final double COSTAL_SHARE = 0.3;
    private static final double BASE_LINK = 4;
    /**
     * Relative stiffness of base springs where the base slides. They follow prescribed anchors and need not carry load.
     */
    private static final double SLIDING_BASE_LINK = 2;

    public final List<Structure> structures;
    public final List<Integer> firstNodes = new ArrayList<>();
    /** Springs from the base to the diaphragm. */
    public final LungBaseMotion.BaseSprings baseSprings =
            new LungBaseMotion.BaseSprings(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());

    private final List<Integer> pleuralNodes = new ArrayList<>();
    /**
     * Nodes of the mediastinal surface, right lung, then left. {@code outwardLoad} holds three numbers per node: the
     * outward normal weighted by tether stiffness.
     */
    private final List<List<Integer>> mediastinal = List.of(new ArrayList<>(), new ArrayList<>());

    private final List<List<Double>> outwardLoad = List.of(new ArrayList<>(), new ArrayList<>());

    /**
     * @param wall null in scenes without a chest wall
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
        double[] parted = {partedMm(lungs, Side.RIGHT, face), partedMm(lungs, Side.LEFT, face)};
        for (Structure s : lungs) {
            double gap = parted[s.side() == Side.LEFT ? 1 : 0];
            TriangleMesh mesh = s.mesh();
            int first = parts.addNodes(mesh, law.masses(mesh, stiffness));
            firstNodes.add(first);
            law.addEdges(parts.passiveSprings, mesh, first, stiffness);
            double[] normals = MeshMeasure.vertexNormals(mesh);
            double[] bed = law.beddingFactors(mesh);
            double[] toBone = bones.distances(mesh.positions());
            for (int i = 0; i < mesh.vertexCount(); i++) {
                double distance = face.closest(mesh.x(i), mesh.y(i), mesh.z(i), FADE_MM + gap, onFace)
                        ? Math.sqrt(onFace.distanceSquared) - gap
                        : FADE_MM;
                boolean costal = wall != null
                        && wall.isAwayFromAxis(mesh.x(i), mesh.y(i))
                        && wall.depth(mesh.x(i), mesh.y(i), mesh.z(i)) < PLEURAL_MM
                        && wall.outwardComponent(mesh.x(i), mesh.y(i), normals[3 * i], normals[3 * i + 1]) > LATERAL;
                if (costal) {
                    pleuralNodes.add(first + i);
                }
                boolean base = distance < (gap > 0 && normals[3 * i + 2] < DOWNWARD ? PARTED_BASE_MM : BASE_MM);
                if (base) {
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

    /** Least distance of a lung from the diaphragm if it is parted from it, mm; else 0. */
    private static double partedMm(List<Structure> lungs, Side side, ThoracicFace face) {
        List<TriangleMesh> lobes = lungs.stream()
                .filter(s -> s.side() == side)
                .map(Structure::mesh)
                .toList();
        double enough = PARTED_SHARE
                * lobes.stream().mapToInt(TriangleMesh::vertexCount).sum();
        TriangleTree.Hit onFace = new TriangleTree.Hit();
        int near = 0;
        double least = PARTED_REACH_MM;
        for (TriangleMesh mesh : lobes) {
            for (int i = 0; i < mesh.vertexCount(); i++) {
                if (face.closest(mesh.x(i), mesh.y(i), mesh.z(i), least + BASE_MM, onFace)) {
                    double distance = Math.sqrt(onFace.distanceSquared);
                    least = Math.min(least, distance);
                    near += distance < BASE_MM ? 1 : 0;
                    if (near >= enough) {
                        return 0;
                    }
                }
            }
        }
        return least < PARTED_REACH_MM ? least : 0;
    }

    /** Scene nodes of the lungs. */
    public IntStream nodes() {
        return IntStream.range(0, structures.size()).flatMap(k -> {
            int first = firstNodes.get(k);
            return IntStream.range(first, first + structures.get(k).mesh().vertexCount());
        });
    }

    /**
     * Load that displaces the mediastinal surface of a lung outward by 1 mm against its tethers: three numbers per
     * scene node, mN.
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
