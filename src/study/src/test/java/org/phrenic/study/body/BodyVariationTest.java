package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

class BodyVariationTest {
    private static final BodyVariation SAME = new BodyVariation(1, 1, 1, 0, 0, 0);
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", new MeshBudget(4000));
    private static final Thorax SCALED = new BodyVariation(1.2, 0.9, 1.1, 0, 0, 0).of(MAN, "scaled");
    private static final Thorax LIFTED = new BodyVariation(1, 1, 1, 0, 0, 20).of(MAN, "lifted");
    private static final Thorax BENT = new BodyVariation(1, 1, 1, 20, 0, 0).of(MAN, "bent");

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
        double volume = MeshMeasure.signedVolume(MAN.find("liver").orElseThrow().mesh());
        assertThat(MeshMeasure.signedVolume(SCALED.find("liver").orElseThrow().mesh()) / volume)
                .isCloseTo(1.2 * 0.9 * 1.1, within(1e-9));
        assertThat(box(SCALED, "rib_07_L")[3]).isCloseTo(1.2 * box(MAN, "rib_07_L")[3], within(1e-9));
    }

    @Test
    void liftRaisesTheDomesAndNeitherTheInsertionNorTheBones() {
        assertThat(box(LIFTED, "diaphragm")[5] - box(MAN, "diaphragm")[5]).isBetween(12.0, 20.0);
        assertThat(box(LIFTED, "diaphragm")[2]).isEqualTo(box(MAN, "diaphragm")[2]);
        assertThat(box(LIFTED, "rib_08_R")).isEqualTo(box(MAN, "rib_08_R"));
    }

    private static TriangleMesh organOf(Thorax body, String name) {
        return body.organs().get().stream()
                .filter(s -> s.name().equals(name))
                .findFirst()
                .orElseThrow()
                .mesh();
    }

    private static double[] organBox(Thorax body, String name) {
        return organOf(body, name).bounds();
    }

    private static double meanHeight(TriangleMesh mesh) {
        return IntStream.range(0, mesh.vertexCount())
                .mapToDouble(mesh::z)
                .average()
                .orElseThrow();
    }

    @Test
    void furtherOrgansAreScaledAndBentWithTheBody() {
        assertThat(SCALED.organs().get())
                .extracting(Structure::name)
                .isEqualTo(MAN.organs().get().stream().map(Structure::name).toList());
        double[] given = organBox(MAN, "kidney_R");
        double[] factors = {1.2, 0.9, 1.1};
        double[] box = organBox(SCALED, "kidney_R");
        for (int side = 0; side < box.length; side++) {
            assertThat(box[side]).isCloseTo(factors[side % 3] * given[side], within(1e-9));
        }
        assertThat(organBox(BENT, "heart")[1]).isLessThan(organBox(MAN, "heart")[1] - 5);
    }

    /** Heart and stomach go on lying beside the left dome, the pleura about the lungs. */
    @Test
    void liftRaisesTheOrgansBesideTheDomesAndThePleura() {
        assertThat(organBox(LIFTED, "stomach")[5] - organBox(MAN, "stomach")[5]).isBetween(8.0, 20.0);
        assertThat(meanHeight(organOf(LIFTED, "heart")) - meanHeight(organOf(MAN, "heart")))
                .isBetween(5.0, 20.0);
        assertThat(organBox(LIFTED, "kidney_R")[2]).isEqualTo(organBox(MAN, "kidney_R")[2]);
        assertThat(organOf(LIFTED, "pleura_R").positions())
                .isNotEqualTo(organOf(MAN, "pleura_R").positions());
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
        assertThat(box(BENT, "vertebra_T01")[1]).isLessThan(box(MAN, "vertebra_T01")[1] - 30);
        assertThat(box(BENT, "vertebra_L03")).isEqualTo(box(MAN, "vertebra_L03"));
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
