package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.file.BadInputException;

/** Entries of plans with a needle of 80 mm, 90 mm from the target at end-expiration. */
class RehearsalEntriesTest {
    @TempDir
    Path folder;

    private void requireEntries(String entry, String aim) throws IOException {
        RehearsalPlan plan = RehearsalPlan.read(Files.writeString(
                folder.resolve("plan.yaml"),
                "target: {rest_mm: [90, 0, 0], diameter_mm: 20}\nneedle: {length_mm: 80}\nsteps: [{place: {entry: "
                        + entry + ", aim: " + aim + "}}]\n"));
        BoxAnatomy body = new BoxAnatomy();
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        Rehearsal.requireEntries(plan, scene, plan.target(scene));
    }

    /** A hand may hold a needle at any angles, and may aim at a target that has come within reach. */
    @ParameterizedTest
    @ValueSource(strings = {"{axial_deg: 90, cranial_deg: 0}", "target", "[75, 0, 0]"})
    void whatAHandCanDoIsNoReasonToRefuseAPlan(String aim) {
        assertThatCode(() -> requireEntries("[0, 0, 0]", aim)).doesNotThrowAnyException();
    }

    @ParameterizedTest
    @ValueSource(strings = {"target-at-end-expiration", "[85, 0, 0]"})
    void anAimThatIsNeverInReachIsRefusedAtOnce(String aim) {
        assertThatThrownBy(() -> requireEntries("[0, 0, 0]", aim))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("step 1, place")
                .hasMessageContaining("expected a longer needle");
    }

    /** The needle is placed on the skin, wherever near it the entry is stated. */
    @Test
    void reachIsThatFromTheSkin() {
        assertThatCode(() -> requireEntries("[-4, 0, 0]", "[78, 0, 0]")).doesNotThrowAnyException();
        assertThatThrownBy(() -> requireEntries("[4, 0, 0]", "[82, 0, 0]"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("needle: found 80 mm for a path of 82.0 mm");
    }

    @Test
    void anEntryWithinTheBodyIsRefusedAtAnyAngles() {
        assertThatThrownBy(() -> requireEntries("[50, 0, 0]", "{axial_deg: 90, cranial_deg: 0}"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("inside the body");
    }
}
