package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;

class BodyVariationTest {
    private static final BodyVariation SAME = new BodyVariation(1, 1, 1, 0, 0, 0);
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    private static double[] box(Thorax body, String structure) {
        return body.find(structure).orElseThrow().mesh().bounds();
    }

    @Test
    void unitFactorsLeaveTheBodyAsItIs() {
        for (Structure s : SAME.of(MAN, "same").structures()) {
            assertThat(s.mesh().positions())
                    .isEqualTo(MAN.find(s.name()).orElseThrow().mesh().positions());
        }
    }

    @Test
    void axesAreScaledOneByOne() {
        Thorax scaled = new BodyVariation(1.2, 0.9, 1.1, 0, 0, 0).of(MAN, "scaled");
        double volume = MeshMeasure.signedVolume(MAN.find("liver").orElseThrow().mesh());
        assertThat(MeshMeasure.signedVolume(scaled.find("liver").orElseThrow().mesh()) / volume)
                .isCloseTo(1.2 * 0.9 * 1.1, within(1e-9));
        assertThat(box(scaled, "rib_07_L")[3]).isCloseTo(1.2 * box(MAN, "rib_07_L")[3], within(1e-9));
    }

    @Test
    void liftRaisesTheDomesAndNeitherTheInsertionNorTheBones() {
        Thorax lifted = new BodyVariation(1, 1, 1, 0, 0, 20).of(MAN, "lifted");
        assertThat(box(lifted, "diaphragm")[5] - box(MAN, "diaphragm")[5]).isBetween(12.0, 20.0);
        assertThat(box(lifted, "diaphragm")[2]).isEqualTo(box(MAN, "diaphragm")[2]);
        assertThat(box(lifted, "rib_08_R")).isEqualTo(box(MAN, "rib_08_R"));
    }

    /** The front of the middle of the cage goes forward, the spine stays. */
    @Test
    void barrelMakesTheChestDeeper() {
        Thorax barrel = new BodyVariation(1, 1, 1, 0, 0.2, 0).of(MAN, "barrel");
        double before = box(MAN, "vertebra_T07")[1] - box(MAN, "rib_06_R")[1];
        double after = box(barrel, "vertebra_T07")[1] - box(barrel, "rib_06_R")[1];
        assertThat(after / before).isBetween(1.1, 1.21);
    }

    /** The first thoracic vertebra goes forward (negative y). */
    @Test
    void kyphosisBendsTheSpineForward() {
        Thorax bent = new BodyVariation(1, 1, 1, 20, 0, 0).of(MAN, "bent");
        assertThat(box(bent, "vertebra_T01")[1]).isLessThan(box(MAN, "vertebra_T01")[1] - 30);
        assertThat(box(bent, "vertebra_L03")).isEqualTo(box(MAN, "vertebra_L03"));
    }

    @Test
    void randomBodiesAreRepeatableAndNoSurfaceIsTurnedInsideOut() {
        for (int number = 1; number <= 4; number++) {
            BodyVariation variation = BodyVariation.random(7, number);
            assertThat(variation)
                    .isEqualTo(BodyVariation.random(7, number))
                    .isNotEqualTo(BodyVariation.random(8, number));
            assertThat(variation.scaleX()).isBetween(0.8, 1.25);
            for (Structure s : variation.of(MAN, "random").structures()) {
                boolean outward = MeshMeasure.signedVolume(
                                MAN.find(s.name()).orElseThrow().mesh())
                        > 0;
                assertThat(MeshMeasure.signedVolume(s.mesh()) > 0).as(s.name()).isEqualTo(outward);
            }
        }
        assertThat(MAN.structuresOf(StructureKind.DIAPHRAGM)).hasSize(1);
    }
}
