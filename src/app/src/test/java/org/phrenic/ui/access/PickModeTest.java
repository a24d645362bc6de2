package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.simulation.observe.Surface;

/** A click whose answer comes after something else is chosen. */
class PickModeTest {
    @Test
    void anAnswerIsForWhatTheClickWasFor() {
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            rehearsal.stage = RehearsalStage.READY;
            PickMode pick = rehearsal.pickMode();
            pick.toggle(PickMode.Kind.ENTRY);
            Consumer<Optional<PickResult>> ofEntry = pick.receiver();
            pick.toggle(PickMode.Kind.PROBE);
            ofEntry.accept(Optional.empty());
            assertThat(pick.mode()).as("the probe's click is still awaited").isEqualTo(PickMode.Kind.PROBE);
            pick.receiver().accept(Optional.empty());
            assertThat(pick.mode()).isEqualTo(PickMode.Kind.NONE);
        });
    }

    /** An arm before the trunk is not in the way. */
    @ParameterizedTest
    @EnumSource(
            value = PickMode.Kind.class,
            names = {"ENTRY", "PROBE"})
    void placesForNeedleAndProbeArePickedOnTheSkinAboutTheLiver(PickMode.Kind kind) {
        Surface arm = UltrasoundUpdaterTest.box("skin_arm_R", StructureKind.SKIN, 210, 50, Surface.Motion.STILL);
        List<Surface> surfaces = new ArrayList<>(RehearsalPreparationTest.surfaces());
        surfaces.add(arm);
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            rehearsal.stage = RehearsalStage.READY;
            rehearsal.body = Optional.of(RehearsalBodyTest.body(surfaces));
            rehearsal.pickMode().toggle(kind);
            ToDoubleFunction<Surface> opacity = rehearsal.pickMode().pickOpacity();
            assertThat(surfaces.stream().map(opacity::applyAsDouble)).containsExactly(1.0, 0.0, 0.0);
        });
    }
}
