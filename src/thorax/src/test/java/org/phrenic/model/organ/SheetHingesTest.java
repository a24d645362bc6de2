package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.engine.force.Hinges;

class SheetHingesTest {
    /** Muscle of one face bends: no hinge reaches to the other face, lies in the tendon or moves with bone. */
    @Test
    void hingesLieOnTheThoracicFaceOfFreeMuscle() {
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.of(130, 90, 110, 3, 12, 0));
        double[] noCrura = new double[dome.sheet().vertexCount()];
        DiaphragmPart.Tissue tissue = new DiaphragmPart.Tissue(TissueLaw.membrane(300, 3), 10, 1, true, noCrura, 1, 1);
        MassSpringBuilder nodes = new MassSpringBuilder();
        DiaphragmPart part = new DiaphragmPart(dome, tissue, nodes);
        Hinges hinges = SheetHinges.of(part, nodes.positions(), 250);
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
}
