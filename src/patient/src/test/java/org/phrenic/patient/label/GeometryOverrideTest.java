package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
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
    @ValueSource(strings = {"1.75", "1,2", "1,2,0", "1,2,-3", "a,b,c", "1,2,3,4", "1,2,NaN", "1,2,99", "1,2,0.05"})
    void anythingElseIsRefusedInOneSentence(String text) {
        assertThatThrownBy(() -> GeometryOverride.spacing(ScanSamples.volume(), text))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("--spacing: found '" + text + "', expected");
    }

    /** A file in metres whose header says nothing of units has voxels of microns. */
    @Test
    void voxelsOfNoScanAreRefused() {
        LabelVolume metres = ScanSamples.volume();
        double[] toMm = metres.grid().toMm();
        for (int i = 0; i < toMm.length; i++) {
            toMm[i] /= 1000;
        }
        LabelVolume volume = new LabelVolume(metres.grid().withAffine(toMm), metres.names(), metres.notes());
        assertThatThrownBy(() -> GeometryOverride.NONE.apply(volume, "scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessage("scan: found voxels of 0.00400 x 0.00400 x 0.00400 mm, expected 0.1 to 50 mm; see"
                        + " --spacing");
        GeometryOverride stated = new GeometryOverride(Optional.empty(), Optional.of("4,4,4"));
        assertThat(stated.apply(volume, "scan").grid().spacing(2)).isCloseTo(4, within(1e-9));
    }

    /** What the window's dialog lets pass is what an import takes. */
    @Test
    void textsOfAxesAndSpacingAreJudgedAsTheyAreTaken() {
        LabelVolume volume = ScanSamples.volume();
        for (String text : List.of("LPS", "ras", " SAL ")) {
            assertThat(GeometryOverride.areAxes(text)).as(text).isTrue();
            assertThat(StatedAxes.letters(GeometryOverride.axes(volume, text)))
                    .isEqualTo(text.strip().toUpperCase(Locale.ROOT));
        }
        for (String text : List.of("LPX", "LLS", "LP", "LPSA", "")) {
            assertThat(GeometryOverride.areAxes(text)).as(text).isFalse();
            assertThatThrownBy(() -> GeometryOverride.axes(volume, text)).isInstanceOf(BadInputException.class);
        }
        assertThat(List.of("1,1,1", "1.75, 1.75, 1.25", "0.1,50,3")).allMatch(GeometryOverride::isSpacing);
        assertThat(List.of("1,1", "1,1,0", "1,1,x", "1,1,51", "1;1;1", "NaN,1,1", ""))
                .noneMatch(GeometryOverride::isSpacing);
    }
}
