package org.phrenic.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;

class PresetRunTest {
    private static final String PITCH = "sternum_pitch_deg";
    private static final double SAMPLE_S = 0.25;

    private static double pitch(String sternum, int trueRibs) {
        Scenario fast = Scenario.defaults()
                .with("mesh_vertices=2000", "lungs=embedded", "liver=false", "rate_per_min=60", "sternum=" + sternum);
        Thorax whole = VirtualThorax.ofPreset("adult-male", OrganSettings.budget(fast));
        Thorax body = new Thorax(
                "part",
                whole.structures().stream()
                        .filter(s -> s.kind() != StructureKind.RIB || s.level() <= trueRibs || s.level() > 7)
                        .toList(),
                List.of());
        return PresetRun.of(fast, body, SAMPLE_S, List.of(PITCH)).value(PITCH, 1);
    }

    /** A sternum that the ribs do not lead, though it may move, has no pitch; one that stands still has one of 0. */
    @Test
    void thePitchOfASternumThatNoRibsLeadIsUnknown() {
        assertThat(pitch("kinematic", 1)).isNaN();
        assertThat(pitch("off", 1)).isZero();
        assertThat(pitch("kinematic", 7)).isPositive();
    }
}
