package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.engine.force.Hinges;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;

class SheetHingesTest {
    private static final double STIFFNESS = 250;

    private final MassSpringBuilder nodes = new MassSpringBuilder();

    /** A dome whose nodes are not the first ones. */
    private DiaphragmPart dome(int rings) {
        nodes.addNodes(Shapes.box(1, 1, 1), new double[8]);
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.of(130, 90, 110, 3, rings, 0));
        double[] noCrura = new double[dome.sheet().vertexCount()];
        return new DiaphragmPart(
                dome, new DiaphragmPart.Tissue(TissueLaw.membrane(300, 3), 10, 1, true, noCrura, 1, 1), nodes);
    }

    private Hinges hinges(DiaphragmPart part) {
        return SheetHinges.of(part, nodes.positions(), STIFFNESS);
    }

    /** The triangles of a sheet by their corners. */
    private static Map<Set<Integer>, Integer> triangles(DiaphragmPart part) {
        int[] t = part.diaphragm.sheet().triangles();
        Map<Set<Integer>, Integer> all = new HashMap<>();
        for (int i = 0; i < t.length; i += 3) {
            all.put(Set.of(t[i], t[i + 1], t[i + 2]), i / 3);
        }
        return all;
    }

    /** Muscle of one face bends: no hinge reaches to the other face, lies in the tendon or moves with bone. */
    @Test
    void hingesLieOnTheThoracicFaceOfFreeMuscle() {
        DiaphragmPart part = dome(12);
        Diaphragm dome = part.diaphragm;
        Hinges hinges = hinges(part);
        // A closed surface has three edges a vertex; half of them lie on the other face.
        assertThat(hinges.count())
                .isBetween(dome.sheet().vertexCount() / 2, 3 * dome.sheet().vertexCount() / 2);
        for (int h = 0; h < hinges.count(); h++) {
            int a = hinges.corners()[4 * h] - part.firstNode;
            int b = hinges.corners()[4 * h + 1] - part.firstNode;
            assertThat(dome.isTendon(a) && dome.isTendon(b)).isFalse();
            assertThat(dome.isInserted(a) && dome.isInserted(b)).isFalse();
            for (int corner = 0; corner < 4; corner++) {
                assertThat(dome.isThoracic(hinges.corners()[4 * h + corner] - part.firstNode))
                        .isTrue();
            }
        }
    }

    @Test
    void aHingeJoinsTheTwoTrianglesOfItsEdgeWithTheStiffnessOfTheSheet() {
        DiaphragmPart part = dome(12);
        Hinges hinges = hinges(part);
        Map<Set<Integer>, Integer> triangles = triangles(part);
        int[] corners = hinges.corners();
        for (int h = 0; h < corners.length; h += 4) {
            int[] c = Arrays.stream(corners, h, h + 4)
                    .map(i -> i - part.firstNode)
                    .toArray();
            assertThat(c[2]).isNotEqualTo(c[3]);
            assertThat(triangles).containsKeys(Set.of(c[0], c[1], c[2]), Set.of(c[0], c[1], c[3]));
        }
        double[] wanted = new double[hinges.count()];
        Arrays.fill(wanted, STIFFNESS);
        assertThat(hinges.rowSums())
                .containsExactly(Hinges.of(nodes.positions(), corners, wanted).rowSums());
    }

    /** Across some edges of a dome of three rings the surface turns by 28 degrees. */
    @Test
    void noHingeIsARidge() {
        DiaphragmPart part = dome(3);
        double[] normals = MeshMeasure.triangleNormals(part.diaphragm.sheet());
        Map<Set<Integer>, Integer> triangles = triangles(part);
        Hinges hinges = hinges(part);
        int[] corners = hinges.corners();
        assertThat(hinges.count()).isPositive();
        for (int h = 0; h < corners.length; h += 4) {
            int[] c = Arrays.stream(corners, h, h + 4)
                    .map(i -> i - part.firstNode)
                    .toArray();
            int one = triangles.get(Set.of(c[0], c[1], c[2]));
            int other = triangles.get(Set.of(c[0], c[1], c[3]));
            double cosine = 0;
            for (int axis = 0; axis < 3; axis++) {
                cosine += normals[3 * one + axis] * normals[3 * other + axis];
            }
            assertThat(cosine).isGreaterThanOrEqualTo(0.9);
        }
    }
}
