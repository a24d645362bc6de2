package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.segmentation.CageVoxels;

class InterpolatedLabelsTest {
    private static LabelGrid grid(LabelGrid as, byte[] labels) {
        return LabelGrid.of(as.columns(), as.rows(), as.slices(), labels, as.toMm());
    }

    /** Each number becomes the mean of its own and that of a voxel before, as half a voxel farther on. */
    private static byte[] halfWay(LabelGrid grid, int step) {
        byte[] labels = new byte[grid.voxelCount()];
        for (int v = step; v < labels.length; v++) {
            labels[v] = (byte) Math.round(0.5 * (grid.label(v - step) + grid.label(v)));
        }
        return labels;
    }

    @Test
    void numbersBetweenThoseOfTwoStructuresAreFoundAtTheirBorders() {
        LabelGrid organs =
                TrunkVoxels.labelled(NumberTable.named("amos").get(0)).grid();
        assertThat(InterpolatedLabels.problem(organs)).isEmpty();
        assertThat(InterpolatedLabels.problem(grid(organs, halfWay(organs, 1))))
                .hasValueSatisfying(problem -> assertThat(problem).contains("were interpolated linearly"));
        assertThat(InterpolatedLabels.problem(
                        new CageVoxels().withRibs(1).withVertebrae(1).volume().grid()))
                .isEmpty();
    }

    /** The left lung, 2, has a shell with the number of the right one. */
    @Test
    void aShellWithTheNumberOfAnotherStructureIsFoundWhereThereIsOneNumberBetween() {
        LabelGrid lungs =
                TrunkVoxels.labelled(NumberTable.named("lungmask").get(0)).grid();
        assertThat(InterpolatedLabels.problem(lungs)).isEmpty();
        assertThat(InterpolatedLabels.problem(grid(lungs, halfWay(lungs, 1 + lungs.columns() * (1 + lungs.rows())))))
                .isPresent();
    }

    /** A skin of one voxel about fat. */
    @Test
    void aThinShellIsNoInterpolation() {
        LabelGrid organs =
                TrunkVoxels.labelled(NumberTable.named("ct-org").get(0)).grid();
        byte[] labels = new byte[organs.voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            int i = v % organs.columns();
            int j = v / organs.columns() % organs.rows();
            int depth = Math.min(Math.min(i, organs.columns() - 1 - i), Math.min(j, organs.rows() - 1 - j));
            labels[v] = (byte) Math.min(depth, 2);
        }
        assertThat(InterpolatedLabels.problem(grid(organs, labels))).isEmpty();
    }
}
