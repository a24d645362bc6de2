package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.SharedThorax;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.edit.ConnectedComponents;

/** The real male thorax, where it lies beside the project. */
class RealThoraxTest {
    private static double[] middle(Thorax thorax, String name) {
        double[] box = thorax.find(name).orElseThrow().mesh().bounds();
        return new double[] {0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), 0.5 * (box[2] + box[5])};
    }

    @Test
    void itStandsInLpsMillimetresAndWhatWasRepairedIsSaid() {
        Thorax thorax = SharedThorax.male();
        assertThat(thorax.structuresOf(StructureKind.RIB)).hasSize(24);
        assertThat(thorax.structuresOf(StructureKind.LUNG)).hasSize(5);
        assertThat(middle(thorax, "sternum_body")[1]).isLessThan(middle(thorax, "vertebra_T06")[1] - 80);
        assertThat(middle(thorax, "rib_05_R")[0]).isNegative();
        assertThat(middle(thorax, "rib_05_L")[0]).isPositive();
        assertThat(middle(thorax, "rib_02_L")[2]).isGreaterThan(middle(thorax, "rib_09_L")[2] + 100);
        assertThat(thorax.notes().get(0)).contains("LSA").contains("1.0 mm");
        assertThat(thorax.notes()).anyMatch(n -> n.startsWith("diaphragm: "));
        double left = thorax.structures().stream()
                .filter(s -> s.kind() == StructureKind.RIB)
                .map(Structure::mesh)
                .mapToDouble(m -> m.bounds()[3])
                .max()
                .orElseThrow();
        // Its rib cage was measured to be 283 mm wide.
        assertThat(left).isBetween(138.0, 146.0);
    }

    /**
     * Their files hold them in two to four patches whose common rims are rounded each for itself; on an open rim a lung
     * crumples.
     */
    @Test
    void aLobeIsOnePieceWithNoHoleButForItsAirways() {
        Thorax thorax = SharedThorax.male();
        for (Structure lobe : thorax.structuresOf(StructureKind.LUNG)) {
            assertThat(ConnectedComponents.of(lobe.mesh())).as(lobe.name()).hasSize(1);
            assertThat(new MeshTopology(lobe.mesh()).boundaryLoops())
                    .as(lobe.name())
                    .hasSizeLessThanOrEqualTo(4)
                    .allMatch(loop -> loop.length <= 20);
        }
    }

    @Test
    void itBreathesQuietlyAsPeopleDo() {
        Runs.Run breath = Runs.run(
                1.9, Runs.scenario("anatomy=" + SharedThorax.path("anatomy/male-thorax")), SharedThorax.male());
        assertThat(breath.fall("dome_right_mm")).as("right dome, mm").isBetween(10.0, 25.0);
        assertThat(breath.fall("dome_left_mm")).as("left dome, mm").isBetween(10.0, 25.0);
        assertThat(breath.rise("lung_volume_change_ml")).as("air, ml").isBetween(300.0, 800.0);
        assertThat(breath.rise("fibre_shortening_percent"))
                .as("fibre shortening, %")
                .isBetween(4.0, 15.0);
        assertThat(breath.most("rigid_link_error")).isLessThanOrEqualTo(1e-4);
    }
}
