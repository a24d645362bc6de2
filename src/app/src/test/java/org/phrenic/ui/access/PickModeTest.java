package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.phrenic.scene.camera.PickResult;

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
}
