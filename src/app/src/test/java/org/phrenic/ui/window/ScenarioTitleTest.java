package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

class ScenarioTitleTest {
    private static final Scenario QUIET = Scenario.defaults();

    private final ScenarioTitle title = new ScenarioTitle();
    private final String plain = QUIET.name() + " - Phrenic";
    private final String marked = QUIET.name() + "* - Phrenic";

    @Test
    void aChangeMarksTheNameUntilItIsTakenBackOrSaved() {
        title.opened(QUIET, Optional.empty());
        assertThat(title.text(QUIET)).isEqualTo(plain);
        Scenario deep = QUIET.with("preset=deep");
        assertThat(title.text(deep)).isEqualTo(marked);
        assertThat(title.text(QUIET)).isEqualTo(plain);
        // Another material loads another scene under the same name.
        title.opened(deep, Optional.empty());
        assertThat(title.text(deep)).isEqualTo(marked);
        title.saved(deep, "mine");
        assertThat(title.text(deep)).isEqualTo("mine - Phrenic");
        assertThat(title.text(QUIET)).isEqualTo("mine* - Phrenic");
    }

    @Test
    void aNameStaysThatOfTheScenario() {
        Scenario named = QUIET.with("name=mine");
        title.opened(QUIET, Optional.empty());
        title.opened(named, Optional.empty());
        assertThat(title.text(named)).isEqualTo("mine - Phrenic");
        assertThat(title.text(named.with("preset=deep"))).isEqualTo("mine* - Phrenic");
    }

    @Test
    void neitherAHoldNorARehearsalIsAChange() {
        title.opened(QUIET, Optional.empty());
        assertThat(title.text(QUIET.with("hold=true", "repeat_breath=true"))).isEqualTo(plain);
    }

    /** Saved without its steps, as they belong to a run. */
    @Test
    void theStepsOfARunAreNoChange() {
        Scenario run = QUIET.with("name=mine", "steps=500");
        title.read(run);
        assertThat(title.text(run)).isEqualTo("mine - Phrenic");
        title.saved(run.without(RunSettings.STEPS), "mine");
        assertThat(title.text(run)).isEqualTo("mine - Phrenic");
    }

    @Test
    void whatTheScenarioItselfChangesIsNoChange() {
        Scenario scheduled = QUIET.with("name=mine")
                .withChanges(List.of(ScheduledChange.parse("100:depth=1.5"), ScheduledChange.parse("200:depth=1.2")));
        title.read(scheduled);
        Scenario read = scheduled.withChanges(List.of());
        for (String change : List.of("depth=1", "depth=1.5", "depth=1.2")) {
            assertThat(title.text(read.with(change))).isEqualTo("mine - Phrenic");
            assertThat(title.losesValues(read.with(change))).isFalse();
        }
        assertThat(title.losesValues(read.with("depth=1.3"))).isTrue();
    }

    @Test
    void aSecondFileOfTheSameNameIsAsUnchangedAsTheFirst() {
        Scenario first = QUIET.with("name=mine", "depth=1.2");
        Scenario second = QUIET.with("name=mine", "depth=0.8");
        title.read(first);
        title.opened(first, Optional.empty());
        title.read(second);
        title.opened(second, Optional.empty());
        assertThat(title.text(second)).isEqualTo("mine - Phrenic");
        assertThat(title.text(first)).as("after undo").isEqualTo("mine - Phrenic");
        assertThat(title.text(second.with("depth=0.9"))).isEqualTo("mine* - Phrenic");
    }

    /** The exercise stays chosen until the breath of another scene is recorded. */
    @Test
    void anExerciseIsNoChangeAndLeavesChangesWhatTheyAre() {
        Scenario changed = QUIET.with("depth=1.2");
        Scenario exercise = QUIET.with("preset=deep");
        title.opened(QUIET, Optional.empty());
        title.opened(exercise, Optional.of(exercise));
        assertThat(title.text(exercise)).isEqualTo(plain);
        title.opened(changed, Optional.of(exercise));
        assertThat(title.text(changed)).as("after undo").isEqualTo(marked);
    }

    /** Who rehearses on patients would learn to close whatever is asked. */
    @Test
    void anotherBodyOrPresetLosesNoValues() {
        title.opened(QUIET, Optional.empty());
        Scenario chosen = QUIET.with("anatomy=virtual/adult-female", "preset=deep");
        assertThat(title.isChanged(chosen)).isTrue();
        assertThat(title.losesValues(chosen)).isFalse();
        assertThat(title.losesValues(chosen.with("depth=1.2"))).isTrue();
    }

    /** Windows of two persons are told apart. */
    @Test
    void aBodyOtherThanTheUsualOneStandsFirst() {
        Scenario person = QUIET.with("anatomy=virtual/adult-female");
        title.opened(person, Optional.empty());
        assertThat(title.text(person)).isEqualTo("adult female, quiet - Phrenic");
        assertThat(title.text(QUIET)).isEqualTo("quiet* - Phrenic");
    }
}
