package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;

/**
 * Sternum and costal cartilages as a stiff mass-spring system that follows the ribs (Villard, Bourne and Bello 2009).
 * It has springs along the edges of each part and across it, ties where two parts meet, and attachments to the ribs
 * that are strong at a rib's end and fade along the cartilage to a low stiffness.
 */
public final class SternumPart {
    /**
     * Stiffness relative to relaxed muscle: the largest that is stable with the paper's step of 0.01 s and uniform node
     * mass at the finest resolution, less 5 %.
     */
    public static final double STIFFNESS = 6.5;

    private static final double REACH_MM = 30;
    private static final int BRACES = 3;

    /** Attachment stiffness at a rib's end and far from it, as shares of an edge's stiffness. */
    private static final double ATTACHED_SHARE = 0.5;

    private static final double FREE_SHARE = 0.05;
    private static final double FADE_MM = 40;

    public final List<Structure> structures = new ArrayList<>();
    public final List<Integer> firstNodes = new ArrayList<>();

    /** A bone or cartilage and the pairs of its vertices that are braced across it. */
    public record BracedStructure(Structure structure, List<OpposingVertices.Pair> braces) {}

    /**
     * Sternum and cartilages of a number of vertices, with their braces. They depend on the body and the budget alone.
     */
    public static List<BracedStructure> mesh(Thorax thorax, MeshBudget budget) {
        List<Structure> given = new ArrayList<>(thorax.structuresOf(StructureKind.STERNUM));
        given.addAll(thorax.structuresOf(StructureKind.COSTAL_CARTILAGE));
        return Remeshing.toBudget(given, budget.sternumVertices()).stream()
                .map(s -> new BracedStructure(
                        s, OpposingVertices.of(s.mesh(), REACH_MM).nearestPairs(BRACES)))
                .toList();
    }

    public SternumPart(MassSpringBuilder parts, List<BracedStructure> meshed, RibCage cage, TissueLaw law) {
        double edge = law.edgeStiffness(2, STIFFNESS);
        for (BracedStructure braced : meshed) {
            Structure s = braced.structure();
            TriangleMesh mesh = s.mesh();
            int first = parts.addNodes(mesh, law.masses(mesh, STIFFNESS));
            structures.add(s);
            firstNodes.add(first);
            law.addEdges(parts.passiveSprings, mesh, first, STIFFNESS);
            double[] p = mesh.positions();
            for (OpposingVertices.Pair pair : braced.braces()) {
                parts.passiveSprings.addEdge(p, first, pair.a(), pair.b(), 0.3 * edge, 0);
            }
            for (int i = 0; i < mesh.vertexCount(); i++) {
                double near = FallOff.at(distanceToRib(cage, s, p, i), FADE_MM);
                parts.attachToBone(first + i, edge * (FREE_SHARE + (ATTACHED_SHARE - FREE_SHARE) * near));
            }
        }
        TieSprings.connect(parts, structures, firstNodes, 0.3 * edge);
    }

    /** Number of nodes. They follow one another from the first of {@link #firstNodes} on. */
    public int nodeCount() {
        return structures.stream().mapToInt(s -> s.mesh().vertexCount()).sum();
    }

    private static double distanceToRib(RibCage cage, Structure s, double[] p, int vertex) {
        int rib = s.kind() == StructureKind.COSTAL_CARTILAGE ? cage.rib(s.level(), s.side()) : -1;
        if (rib < 0) {
            return FADE_MM;
        }
        return MassSpringBuilder.distance(
                p, vertex, cage.bodies().get(rib).ends().orElseThrow().anterior(), 0);
    }
}
