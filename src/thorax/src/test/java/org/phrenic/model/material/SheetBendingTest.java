package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.engine.force.Hinges;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.TissueLaw;

class SheetBendingTest {
    @Test
    void aStiffnessInNewtonMillimetresIsAThousandMillinewtonMillimetres() {
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.adult(6));
        MassSpringBuilder nodes = new MassSpringBuilder();
        double[] noCrura = new double[dome.sheet().vertexCount()];
        TissueLaw law = TissueLaw.membrane(300, 3);
        DiaphragmPart part = new DiaphragmPart(dome, new DiaphragmPart.Tissue(law, 10, 1, true, noCrura, 1, 1), nodes);
        Hinges hinges = SheetBending.hinges(part, nodes.positions(), 0.1);
        double[] milli = new double[hinges.count()];
        Arrays.fill(milli, 100);
        assertThat(hinges.rowSums())
                .isNotEmpty()
                .containsExactly(
                        Hinges.of(nodes.positions(), hinges.corners(), milli).rowSums());
    }
}
