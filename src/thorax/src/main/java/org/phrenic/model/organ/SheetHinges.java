package org.phrenic.model.organ;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.engine.force.Hinges;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;

/**
 * The edges across which the muscle of a diaphragm resists bending: those of its thoracic face, which stands for the
 * sheet, for struts keep the abdominal face at its distance.
 *
 * <p>Edges within the tendon are left out, and those at the insertion, which bone moves. So are ridges of the given
 * shape: a surface with an edge has no curvature there.
 */
public final class SheetHinges {
    /** Least cosine between the normals of the two triangles at rest; 25 degrees. */
    private static final double LEAST_COSINE = 0.9;

    private final DiaphragmPart part;
    private final Diaphragm diaphragm;
    private final double[] normals;

    private SheetHinges(DiaphragmPart part) {
        this.part = part;
        diaphragm = part.diaphragm;
        normals = MeshMeasure.triangleNormals(diaphragm.sheet());
    }

    /**
     * Hinges on scene nodes.
     *
     * @param positions of all nodes at rest, mm
     * @param stiffness bending stiffness of the whole sheet, mN mm
     */
    public static Hinges of(DiaphragmPart part, double[] positions, double stiffness) {
        int[] nodes = new SheetHinges(part).nodes();
        double[] all = new double[nodes.length / 4];
        Arrays.fill(all, stiffness);
        return Hinges.of(positions, nodes, all);
    }

    private int[] nodes() {
        MeshTopology topology = diaphragm.topology();
        List<int[]> hinges = new ArrayList<>();
        for (int e = 0; e < topology.edgeCount(); e++) {
            int one = topology.face(e, 0);
            int other = topology.face(e, 1);
            if (one < 0 || other < 0 || isRidge(one, other)) {
                continue;
            }
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            int[] hinge = {a, b, opposite(one, a, b), opposite(other, a, b)};
            if (bends(hinge)) {
                hinges.add(MassSpringBuilder.offset(hinge, part.firstNode));
            }
        }
        return hinges.stream().flatMapToInt(Arrays::stream).toArray();
    }

    private boolean isRidge(int one, int other) {
        double cosine = 0;
        for (int axis = 0; axis < 3; axis++) {
            cosine += normals[3 * one + axis] * normals[3 * other + axis];
        }
        return !(cosine >= LEAST_COSINE);
    }

    private boolean bends(int[] hinge) {
        boolean inTendon = diaphragm.isTendon(hinge[0]) && diaphragm.isTendon(hinge[1]);
        boolean inserted = diaphragm.isInserted(hinge[0]) && diaphragm.isInserted(hinge[1]);
        return !inTendon && !inserted && Arrays.stream(hinge).allMatch(diaphragm::isThoracic);
    }

    private int opposite(int triangle, int a, int b) {
        int[] t = diaphragm.sheet().triangles();
        int sum = t[3 * triangle] + t[3 * triangle + 1] + t[3 * triangle + 2];
        return sum - a - b;
    }
}
