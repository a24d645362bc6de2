package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.scenario.Scenario;

/** One quiet breath (4 s) of the virtual adult male with everything switched on; ranges from measurements in people. */
class QuietBreathTest {
    static final double BREATH_S = 4;
    /** The domes stand lowest within this time. */
    static final double INSPIRATION_S = 1.9;

    private static Runs.Run breath;

    @BeforeAll
    static void breathe() {
        breath = Runs.of(BREATH_S);
    }

    @Test
    void bothDomesDescendAsFarAsUltrasoundMeasures() {
        // M-mode ultrasound of men, quiet breathing: 18 +/- 3 and 18 +/- 4 mm (Boussuges et al. 2009), +/- 2 SD.
        assertThat(breath.fall("dome_right_mm")).isBetween(12.0, 24.0);
        assertThat(breath.fall("dome_left_mm")).isBetween(10.0, 26.0);
        assertThat(breath.rise("dome_right_mm")).isLessThan(2);
    }

    @Test
    void theBackOfTheDomeGoesFartherThanTheFront() {
        // Gierada et al. 1995: excursion grows from front to back.
        for (String side : new String[] {"right", "left"}) {
            assertThat(breath.fall("posterior_" + side + "_mm"))
                    .isGreaterThan(breath.fall("middle_" + side + "_mm"))
                    .isGreaterThan(breath.fall("anterior_" + side + "_mm"));
        }
    }

    @Test
    void chestGrowsForwardAndSidewaysAndTheLungsTakeInATidalVolume() {
        // De Groote et al. 1997: upper rib cage 3 to 5 mm, sideways 1 to 2 mm; tidal volume 300 to 800 ml.
        assertThat(breath.rise("ap_change_mm")).isBetween(1.0, 6.0);
        assertThat(breath.rise("transverse_change_mm")).isBetween(0.5, 5.0);
        assertThat(breath.rise("sternum_cranial_mm")).isBetween(2.0, 8.0);
        assertThat(breath.rise("lung_volume_change_ml")).isBetween(300.0, 800.0);
    }

    @Test
    void theLiverGoesDownWithTheDome() {
        // Free breathing, fiducials: 5.1 to 17.3 mm, forward 0.9 to 7.7 (PMC5978939).
        assertThat(breath.fall("liver_si_mm")).isBetween(5.0, 20.0).isLessThan(breath.fall("dome_right_mm") + 2);
        assertThat(breath.most("liver_ap_mm")).isLessThan(8);
    }

    @Test
    void muscleFibresShortenAndComeBack() {
        assertThat(breath.rise("fibre_shortening_percent")).isBetween(4.0, 15.0);
        assertThat(breath.last().get("fibre_shortening_percent")).isCloseTo(0, within(1.0));
    }

    @Test
    void rigidLinksKeepTheirLengths() {
        assertThat(breath.links()).isPositive();
        assertThat(breath.most("rigid_link_error")).isLessThanOrEqualTo(1e-4);
    }

    @Test
    void afterTheBreathTheShapeIsThatOfRest() {
        assertThat(breath.seen().get(0).get("from_rest_rms_mm")).isCloseTo(0, within(1e-9));
        assertThat(breath.most("from_rest_rms_mm")).isGreaterThan(4);
        assertThat(breath.last().get("from_rest_rms_mm")).isLessThan(0.5);
    }

    @Test
    void ribsTurnASixthOfTheWayToFullInspiration() {
        assertThat(breath.most("rib_turn")).isCloseTo(1.0 / 6, within(0.01));
        assertThat(breath.last().get("rib_turn")).isCloseTo(0, within(1e-9));
    }

    /** Half the step of the same inspiration; of a coarser mesh, for its length counts alone. */
    @Test
    void halfTheStepGivesTheSameExcursionWithinAHundredth() {
        Runs.Run whole = Runs.of(INSPIRATION_S, "mesh_vertices=3000");
        double dt = Scenario.defaults().timeStepS() / whole.substeps() / 2;
        Runs.Run fine = Runs.of(INSPIRATION_S, "mesh_vertices=3000", "time_step_s=" + dt);
        assertThat(fine.substeps()).isEqualTo(1);
        double coarse = whole.fall("dome_right_mm");
        assertThat(fine.fall("dome_right_mm")).isCloseTo(coarse, within(0.01 * coarse));
    }

    /** The mesh of the breath against one of half its vertices, whose edges are 1.4 times as long. */
    @Test
    void aFinerMeshGivesTheSameExcursionWithinATwentieth() {
        Runs.Run medium = Runs.run(
                INSPIRATION_S,
                Scenario.defaults().with("resolution=medium"),
                VirtualThorax.ofPreset("adult-male", Resolution.MEDIUM));
        assertThat(medium.nodes()).isGreaterThan(breath.nodes());
        double coarse = breath.fall("dome_right_mm");
        assertThat(medium.fall("dome_right_mm")).isCloseTo(coarse, within(0.05 * coarse));
    }
}
