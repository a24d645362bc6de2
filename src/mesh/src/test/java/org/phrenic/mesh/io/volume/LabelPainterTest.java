package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;

class LabelPainterTest {
    /** Labels above 255 take two bytes a voxel: of a third of the memory, one byte each would fit. */
    @Test
    void moreLabelsThanFitIntoMemoryAreRefusedWithASentence() {
        int slice = 1000 * 1000;
        int slices = (int) (Runtime.getRuntime().maxMemory() / 3 / slice);
        assumeTrue(slices <= 2000, "an array holds fewer voxels than a third of this memory");
        LabelPainter painter = new LabelPainter("scan.dcm", 1000, 1000, slices);
        assertThatThrownBy(() -> painter.allocate(256))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("scan.dcm: found a size of 1000 x 1000 x " + slices)
                .hasMessageContaining("half of Java's memory");
    }
}
