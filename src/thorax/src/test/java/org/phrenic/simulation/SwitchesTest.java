package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Every part of the model can be taken out, and then it is gone. */
class SwitchesTest {
    private static final double QUARTER_BREATH_S = 1;
    /** A coarser body than that of the other tests: what a part does, and what links keep, is no matter of the mesh. */
    private static final String COARSE = "mesh_vertices=3000";
    /** A sheet that nothing drives goes less far from its shape at rest, rms, mm. */
    private static final double STILL_MM = 0.05;

    private static final String[] THREE_LINKS = Runs.sheetAlone("links_per_node=3", "tendon=plane", COARSE);

    @Test
    void everyPartThatIsSwitchedOffIsGone() {
        Runs.Run sheet = Runs.of(0, Runs.sheetAlone(COARSE));
        Runs.Run withSternum = Runs.of(0, "lungs=embedded", COARSE);
        assertThat(withSternum.nodes()).isGreaterThan(sheet.nodes());
        assertThat(withSternum.springs()).isGreaterThan(sheet.springs());
        assertThat(withSternum.attachments()).isGreaterThan(sheet.attachments());
        assertThat(withSternum.links()).isEqualTo(sheet.links()).isPositive();
        Runs.Run whole = Runs.of(0, COARSE);
        assertThat(whole.nodes()).isGreaterThan(withSternum.nodes());
        assertThat(whole.springs()).isGreaterThan(withSternum.springs());
        Runs.Run bare = Runs.of(
                QUARTER_BREATH_S,
                "lungs=off",
                "sternum=off",
                "tensegrity=false",
                "contact=false",
                "liver=false",
                "muscle=false",
                "pressure=false",
                "ribs=false",
                COARSE);
        assertThat(bare.nodes()).isEqualTo(sheet.nodes());
        assertThat(bare.links()).isZero();
        assertThat(bare.most("lung_volume_change_ml")).isNaN();
        assertThat(bare.most("liver_si_mm")).isNaN();
        assertThat(bare.most("sternum_cranial_mm")).isZero();
        assertThat(bare.most("from_rest_rms_mm")).as("nothing drives it").isLessThan(STILL_MM);
        assertThat(bare.most("rigid_link_error")).isZero();
    }

    @Test
    void withRibsOffTheDiaphragmBreathesAlone() {
        Runs.Run still = Runs.of(QUARTER_BREATH_S, Runs.sheetAlone("ribs=false", COARSE));
        assertThat(still.most("rib_turn")).isZero();
        assertThat(still.most("sternum_cranial_mm")).isZero();
        assertThat(still.most("sternum_ventral_mm")).isZero();
        assertThat(still.most("transverse_change_mm")).isZero();
        assertThat(still.fall("dome_right_mm")).isGreaterThan(3);
    }

    @Test
    void withoutMuscleAndEffortOnlyTheRibsMoveTheSheet() {
        Runs.Run passive = Runs.of(QUARTER_BREATH_S, Runs.sheetAlone("muscle=false", "pressure=false", COARSE));
        assertThat(passive.most("rib_turn")).isGreaterThan(0.05);
        assertThat(Math.abs(passive.last().get("dome_right_mm"))).isLessThan(4);
        assertThat(passive.most("from_rest_rms_mm")).as("the sheet follows").isGreaterThan(2 * STILL_MM);
    }

    /** Links that share nodes disturb each other; every sweep over them reduces what is left of their error. */
    @Test
    void moreSweepsLeaveLessErrorInLinksThatShareNodes() {
        String[] once = Runs.sheetAlone("links_per_node=3", "tendon=plane", "projection_sweeps=1", COARSE);
        assertThat(Runs.of(0.3, once).most("rigid_link_error"))
                .isGreaterThan(1.5 * Runs.of(0.3, THREE_LINKS).most("rigid_link_error"));
    }

    @Test
    void anyTendonRuleAndUpToThreeLinksANodeKeepTheLinksLengths() {
        Runs.Run one = Runs.of(0, Runs.sheetAlone(COARSE));
        Runs.Run three = Runs.of(0.3, THREE_LINKS);
        assertThat(three.links()).isGreaterThan(one.links());
        assertThat(three.most("rigid_link_error")).isLessThanOrEqualTo(1e-4);
        assertThat(three.last().get("dome_right_mm")).isCloseTo(0, within(10.0));
    }
}
