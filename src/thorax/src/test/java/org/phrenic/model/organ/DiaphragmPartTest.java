package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;

class DiaphragmPartTest {
    /** A thin diaphragm; people's are 2 to 5 mm. */
    private static final double THIN_MM = 2;
    /** Distance from the insertion beyond which every vertex has one opposite it. */
    private static final double BORDER_MM = 30;

    /**
     * The thoracic face may touch the wall. The abdominal face stops behind it while something is left of a thin
     * sheet's thickness, and at rest, a thickness away, it is free.
     */
    @Test
    void theAbdominalFaceStopsWithinTheThicknessOfAThinSheet() {
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.of(130, 90, 110, THIN_MM, 12, 0));
        double[] noCrura = new double[dome.sheet().vertexCount()];
        DiaphragmPart.Tissue tissue = new DiaphragmPart.Tissue(TissueLaw.membrane(300, 3), 10, 1, true, noCrura, 1, 1);
        DiaphragmPart part = new DiaphragmPart(dome, tissue, new MassSpringBuilder());
        for (int v = 0; v < dome.sheet().vertexCount(); v++) {
            if (dome.isThoracic(v)) {
                assertThat(part.wallInset(v)).isZero();
            } else if (dome.distanceFromInsertion(v) > BORDER_MM) {
                assertThat(part.wallInset(v)).isGreaterThan(THIN_MM / 2).isLessThan(THIN_MM);
            }
        }
    }
}
