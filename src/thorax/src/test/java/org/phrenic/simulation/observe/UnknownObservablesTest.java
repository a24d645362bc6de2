package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;

class UnknownObservablesTest {
    private static final Scenario SHEET_ALONE =
            Scenario.defaults().with("resolution=low").with(Runs.SHEET_ALONE).with("liver=false");
    private static final String[] OF_LIVER = {"liver_si_mm", "liver_ap_mm", "liver_lr_mm"};
    private static final String[] OF_STERNUM = {"ap_change_mm", "sternum_cranial_mm", "sternum_ventral_mm"};
    private static final String WIDTH = "transverse_change_mm";

    private static Set<String> unknown(String sternum, Predicate<Structure> left) {
        Thorax whole = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        Thorax body =
                new Thorax("part", whole.structures().stream().filter(left).toList(), List.of());
        return UnknownObservables.of(Runs.assembled(SHEET_ALONE.with("sternum=" + sternum), body));
    }

    private static boolean isRib(Structure s) {
        return s.kind() == StructureKind.RIB;
    }

    @Test
    void ofAWholeBodyOnlyWhatIsSwitchedOffIsUnknown() {
        assertThat(unknown("kinematic", s -> true)).containsExactlyInAnyOrder(OF_LIVER);
    }

    /** As with ascites: the roof of the liver lies too far below the sheet to be carried by it. */
    @Test
    void theMotionOfALiverThatNothingCarriesIsUnknown() {
        for (double lowered : new double[] {0, 60}) {
            Scene scene = Runs.assembled(SHEET_ALONE.with("liver=true"), withLiverLowered(lowered));
            assertThat(UnknownObservables.of(scene).containsAll(List.of(OF_LIVER)))
                    .isEqualTo(lowered > 0);
        }
    }

    /** As one that is switched off; needle paths are not judged on it. */
    @Test
    void aLiverThatNothingCarriesStandsStill() {
        for (double lowered : new double[] {0, 60}) {
            Scenario scenario = SHEET_ALONE.with("liver=true");
            try (Simulation simulation = Simulation.of(scenario, withLiverLowered(lowered))) {
                assertThat(new SceneSurfaces(simulation).surfaces())
                        .filteredOn(s -> s.kind() == StructureKind.LIVER)
                        .extracting(Surface::motion)
                        .containsExactly(lowered > 0 ? Surface.Motion.STILL : Surface.Motion.DEFORMING);
            }
        }
    }

    private static Thorax withLiverLowered(double mm) {
        Thorax whole = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        return new Thorax(
                "ascites",
                whole.structures().stream()
                        .map(s -> s.kind() == StructureKind.LIVER ? lowered(s, mm) : s)
                        .toList(),
                List.of());
    }

    private static Structure lowered(Structure s, double mm) {
        double[] p = s.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] -= mm;
        }
        return new Structure(s.name(), s.kind(), s.level(), s.side(), s.mesh().withPositions(p));
    }

    @Test
    void theMotionOfASternumThatABodyLacksIsUnknown() {
        for (String model : List.of("kinematic", "off")) {
            assertThat(unknown(model, s -> s.kind() != StructureKind.STERNUM))
                    .contains(OF_STERNUM)
                    .doesNotContain(WIDTH);
        }
    }

    /** Two true ribs lead no sternum; one that stands still moves by 0, which is known. */
    @Test
    void theMotionOfASternumThatNoRibsLeadIsUnknown() {
        Predicate<Structure> fewTrueRibs = s -> !isRib(s) || s.level() == 1 || s.level() > 7;
        assertThat(unknown("kinematic", fewTrueRibs)).contains(OF_STERNUM).doesNotContain(WIDTH);
        assertThat(unknown("off", fewTrueRibs)).doesNotContain(OF_STERNUM);
    }

    @Test
    void theWidthBetweenRibsThatABodyLacksIsUnknown() {
        assertThat(unknown("off", s -> !isRib(s) || s.side() == Side.RIGHT)).contains(WIDTH);
        assertThat(unknown("off", s -> !isRib(s) || s.side() == Side.LEFT)).contains(WIDTH);
        assertThat(unknown("off", s -> !isRib(s) || s.level() < 5)).contains(WIDTH);
        assertThat(unknown("off", s -> !isRib(s) || s.level() == 10)).doesNotContain(WIDTH);
    }
}
