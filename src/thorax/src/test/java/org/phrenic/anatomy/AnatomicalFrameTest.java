package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;

class AnatomicalFrameTest {
    private static final double ROUNDING_MM = 1e-9;

    @ParameterizedTest
    @CsvSource({"LPS, 1", "RAS, 1", "LSA, 1", "RSP, 10", "LSA, 1000", "AIL, 10", "SLP, 1"})
    void axesAndUnitAreReadOffTheBodyAndItComesBackInLpsMillimetres(String axes, double unit) {
        List<Structure> body = BoxBody.structures();
        List<Structure> given = BoxBody.given(body, axes, unit);
        AnatomicalFrame frame = AnatomicalFrame.detect(given);
        assertThat(frame).isEqualTo(new AnatomicalFrame(axes, unit));
        assertThat(AnatomicalFrame.ofStatedAxes(axes, given)).isEqualTo(frame);
        for (int i = 0; i < body.size(); i++) {
            assertThat(frame.toLps(given.get(i).mesh()).positions())
                    .containsExactly(body.get(i).mesh().positions(), within(ROUNDING_MM));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"LPS", "RAS", "LSA", "PIR"})
    void aSurfaceThatFacesOutwardStillDoesInLps(String axes) {
        assertThat(MeshMeasure.signedVolume(new AnatomicalFrame(axes, 1).toLps(BoxBody.box(3, 4, 5, 10))))
                .isCloseTo(8000, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(strings = {"RPS", "LAS", "LPI", "SPL"})
    void leftHandedAxesAreRefused(String axes) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AnatomicalFrame(axes, 1))
                .withMessageContaining(axes)
                .withMessageContaining("mirrored");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "LP", "LLS", "XYZ", "LRS", "LPSA"})
    void whatAreNoAxesIsRefusedWithAnExampleOfSome(String axes) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AnatomicalFrame(axes, 1))
                .withMessageContaining("'" + axes + "'")
                .withMessageContaining("LPS");
    }

    @Test
    void aBodyWhoseSidesAreExchangedIsRefused() {
        List<Structure> mirrored =
                BoxBody.structures().stream().map(BoxBody::mirrored).toList();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnatomicalFrame.detect(mirrored))
                .withMessageContaining("mirrored")
                .withMessageContaining("left and right are exchanged");
    }

    @Test
    void withoutBonesTheSentenceSaysWhatToState() {
        List<Structure> only = BoxBody.structures().stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .toList();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnatomicalFrame.detect(only))
                .withMessageContaining("ribs of both sides, vertebrae and sternum")
                .withMessageContaining("'axes: ...' in thorax.yaml");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnatomicalFrame.ofStatedAxes("LPS", only))
                .withMessageContaining("'units: mm' in thorax.yaml");
    }

    @Test
    void aRibCageAsWideAsAHouseIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnatomicalFrame.detect(BoxBody.given(BoxBody.structures(), "LPS", 0.05)))
                .withMessageContaining("6000 units wide")
                .withMessageContaining("100 to 500 mm");
    }

    @Test
    void bonesAllInOnePlaceGiveNoFrameAndASentence() {
        List<Structure> heap = BoxBody.structures().stream()
                .map(s -> s.withMesh(
                        BoxBody.box(s.side().sign() * 100, 0, s.side().sign() * 200, 10)))
                .toList();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnatomicalFrame.detect(heap))
                .withMessageContaining("axes");
    }
}
