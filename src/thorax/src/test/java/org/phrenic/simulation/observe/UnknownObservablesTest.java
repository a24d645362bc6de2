package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;

class UnknownObservablesTest {
    private static final Scenario SHEET_ALONE =
            Scenario.defaults().with("resolution=low").with(Runs.SHEET_ALONE).with("liver=false");

    @Test
    void theMotionOfASternumThatABodyLacksIsUnknown() {
        Thorax whole = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        List<Structure> others = whole.structures().stream()
                .filter(s -> s.kind() != StructureKind.STERNUM)
                .toList();
        Thorax body = new Thorax("no sternum", others, List.of());
        for (String model : List.of("sternum=kinematic", "sternum=off")) {
            assertThat(UnknownObservables.of(Runs.assembled(SHEET_ALONE.with(model), body)))
                    .contains("ap_change_mm", "sternum_cranial_mm", "sternum_ventral_mm");
        }
    }
}
