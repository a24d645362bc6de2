package org.phrenic.mesh.voxel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LabelGridTest {
    private static final double[] UNIT = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    @Test
    void theBoxHoldsAllVoxelsOfTheLabelsAskedForAndNoMore() {
        byte[] labels = new byte[5 * 4 * 3];
        labels[1 + 5 * (2 + 4 * 0)] = 7;
        labels[3 + 5 * (1 + 4 * 2)] = 7;
        labels[4 + 5 * (3 + 4 * 1)] = (byte) 200;
        LabelGrid grid = LabelGrid.of(5, 4, 3, labels, UNIT);
        assertThat(grid.box(label -> label == 7)).containsExactly(1, 1, 0, 3, 2, 2);
        assertThat(grid.box(label -> label == 200)).containsExactly(4, 3, 1, 4, 3, 1);
        assertThat(grid.box(label -> label != 0)).containsExactly(1, 1, 0, 4, 3, 2);
        assertThat(grid.box(label -> label == 9)).endsWith(-1, -1, -1);
    }
}
