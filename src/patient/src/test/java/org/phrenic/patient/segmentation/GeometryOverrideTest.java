package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.ScanSamples;

class GeometryOverrideTest {
    @Test
    void voxelsGetTheStatedSizeAboutTheSameMiddle() {
        LabelGrid before = ScanSamples.volume().grid();
        LabelGrid after =
                GeometryOverride.spacing(ScanSamples.volume(), "1.75, 1.5,1.25").grid();
        assertThat(new double[] {after.spacing(0), after.spacing(1), after.spacing(2)})
                .containsExactly(new double[] {1.75, 1.5, 1.25}, within(1e-12));
        double[] a = new double[3];
        double[] b = new double[3];
        before.voxelToMm(29.5, 19.5, 24.5, a);
        after.voxelToMm(29.5, 19.5, 24.5, b);
        assertThat(b).containsExactly(a, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"1.75", "1,2", "1,2,0", "1,2,-3", "a,b,c", "1,2,3,4", "1,2,NaN", "1,2,99"})
    void anythingElseIsRefusedInOneSentence(String text) {
        assertThatThrownBy(() -> GeometryOverride.spacing(ScanSamples.volume(), text))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("--spacing: found '" + text + "', expected");
    }
}
