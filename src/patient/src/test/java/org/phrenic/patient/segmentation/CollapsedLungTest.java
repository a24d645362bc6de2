package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/** A right lung of 1,200 ml, and a left one of 91 ml joined to it by a bronchus, under one label. */
class CollapsedLungTest {
    private static final int LUNG_ML = 1200;
    private static final int COLLAPSED_MM = 45;

    private final List<String> notes = new ArrayList<>();

    /** Voxels of these sizes in mm. */
    private static Segmentation lungs(double across, double along, int bronchusMm) {
        double[] spacing = {across, across, along};
        int[] size = Arrays.stream(new int[] {0, 1, 2})
                .map(n -> (int) (180 / spacing[n]))
                .toArray();
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        fill(labels, size, spacing, new int[] {5, 10, 10}, new int[] {100, 100, 120});
        fill(labels, size, spacing, new int[] {105, 50, 70}, new int[] {20, bronchusMm, bronchusMm});
        int side = COLLAPSED_MM;
        fill(labels, size, spacing, new int[] {125, 40, 60}, new int[] {side, side, side});
        double[] toMm = {across, 0, 0, 0, 0, across, 0, 0, 0, 0, along, 0};
        LabelVolume volume =
                new LabelVolume(LabelGrid.of(size[0], size[1], size[2], labels, toMm), Map.of(), List.of());
        return new Segmentation(volume, new LabelTable(Map.of(1, LabelTable.LUNGS)), "scan");
    }

    private static void fill(byte[] labels, int[] size, double[] spacing, int[] fromMm, int[] lengthMm) {
        for (int v = 0; v < labels.length; v++) {
            int[] index = {v % size[0], v / size[0] % size[1], v / size[0] / size[1]};
            boolean inside = true;
            for (int axis = 0; axis < 3; axis++) {
                double beyond = (index[axis] + 0.5) * spacing[axis] - fromMm[axis];
                inside &= beyond > 0 && beyond < lengthMm[axis];
            }
            labels[v] = inside ? 1 : labels[v];
        }
    }

    private static double volumeMl(Segmentation s, String lung) {
        return s.grid().volumeMl(s.counts()[s.find(lung)]);
    }

    /** Voxels of 1 mm, coarse ones, and thick slices. */
    @ParameterizedTest
    @CsvSource({"1, 1", "2.5, 2.5", "1, 5"})
    void itIsToldByItsWholeVolumeThoughABronchusOf12MmJoinsIt(double across, double along) {
        Segmentation s = lungs(across, along, 12);
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(volumeMl(s, "lung_R")).isCloseTo(LUNG_ML, within(10.0));
        assertThat(volumeMl(s, "lung_L")).isCloseTo(Math.pow(COLLAPSED_MM, 3) / 1000, within(6.0));
        assertThat(notes).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2.5, 2.5", "1, 5"})
    void itIsNotToldWhereWhatJoinsItIs20MmWide(double across, double along) {
        Optional<String> problem = LungSplitter.split(lungs(across, along, 20), notes);
        assertThat(problem.orElseThrow()).contains("found one body that does not part into two side by side");
    }
}
