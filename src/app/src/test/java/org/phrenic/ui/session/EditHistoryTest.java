package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import javax.swing.undo.UndoableEdit;
import org.junit.jupiter.api.Test;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

class EditHistoryTest {
    private static final long LONG_NS = 10 * EditHistory.COALESCE_NS;

    private final AtomicLong clock = new AtomicLong(1);
    private Scenario scenario = Scenario.defaults();
    private final EditHistory history = new EditHistory(clock::get);

    private void change(EditName name, String... texts) {
        List<Assignment> list = Arrays.stream(texts).map(Assignment::parse).toList();
        Scenario before = scenario;
        List<Assignment> inverse = list.stream()
                .map(a -> new Assignment("undo", a.setting(), before.get(a.setting())))
                .toList();
        scenario = before.with(list);
        history.add(
                name,
                list.stream().map(Assignment::key).toList(),
                () -> scenario = scenario.with(inverse),
                () -> scenario = scenario.with(list));
    }

    private void pass(long ns) {
        clock.addAndGet(ns);
    }

    @Test
    void undoNamesTheChangeAndRestoresTheValue() {
        change(new EditName("Muscle stiffness", "300", "450 N/m"), "muscle_stiffness_n_per_m=450");
        assertThat(history.undoPresentationName()).hasValue("Undo Muscle stiffness 300 -> 450 N/m");
        history.undo();
        assertThat(scenario).isEqualTo(Scenario.defaults());
        assertThat(history.undoPresentationName()).isEmpty();
        assertThat(history.redoPresentationName()).hasValue("Redo Muscle stiffness 300 -> 450 N/m");
        history.redo();
        assertThat(scenario.get(SheetSprings.MUSCLE_STIFFNESS)).isEqualTo(450);
    }

    @Test
    void aDraggedSliderIsOneChange() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        pass(EditHistory.COALESCE_NS / 2);
        change(new EditName("Depth", "1.1", "1.4"), "depth=1.4");
        assertThat(history.undoPresentationName()).hasValue("Undo Depth 1 -> 1.4");
        history.undo();
        assertThat(scenario.get(Breathing.DEPTH)).isEqualTo(1);
        history.redo();
        assertThat(scenario.get(Breathing.DEPTH)).isEqualTo(1.4);
    }

    @Test
    void changesOfOtherKeysOrAfterAWhileOrAfterTheSliderWasLetGoAreTheirOwn() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        change(new EditName("Rib rotation", "1", "1.2"), "rib_rotation=1.2");
        pass(LONG_NS);
        change(new EditName("Rib rotation", "1.2", "1.3"), "rib_rotation=1.3");
        history.endMerging();
        change(new EditName("Rib rotation", "1.3", "1.4"), "rib_rotation=1.4");
        history.undo();
        history.undo();
        history.undo();
        assertThat(history.undoPresentationName()).hasValue("Undo Depth 1 -> 1.1");
        assertThat(scenario.get(RibRotation.RIB_ROTATION)).isEqualTo(1);
    }

    @Test
    void aValueThatThePresetGaveComesBackThoughTheScenarioDidNotStateIt() {
        change(new EditName("Rate", "15", "22 1/min"), "rate_per_min=22");
        history.undo();
        assertThat(scenario.get(Breathing.RATE)).isEqualTo(15);
    }

    @Test
    void whatHadNoValueBringsTheWholeScenarioBack() {
        change(EditName.of("Duration 3 s"), "duration_s=3");
        history.undo();
        assertThat(scenario.durationS()).isNaN();
    }

    @Test
    void aStructuralChangeAndALoadedScenarioAreUndoneToo() {
        change(new EditName("Resolution", "medium", "low"), "resolution=low");
        pass(LONG_NS);
        Scenario deep = scenario.with("preset=deep");
        Scenario low = scenario;
        scenario = deep;
        history.add(EditName.of("Settings 'deep'"), List.of(), () -> scenario = low, () -> scenario = deep);
        assertThat(scenario).isEqualTo(deep);
        history.undo();
        history.undo();
        assertThat(scenario).isEqualTo(Scenario.defaults());
    }

    @Test
    void aNewChangeForgetsWhatWasTakenBack() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        history.undo();
        change(new EditName("Depth", "1", "1.2"), "depth=1.2");
        assertThat(history.redoPresentationName()).isEmpty();
    }

    @Test
    void aChangeThatCouldNotBeMadeIsForgotten() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        UndoableEdit failed = history.add(EditName.of("Open scan"), List.of(), () -> {}, () -> {});
        assertThat(history.undoPresentationName()).hasValue("Undo Open scan");
        history.retract(failed);
        assertThat(history.undoPresentationName()).hasValue("Undo Depth 1 -> 1.1");
        assertThat(history.redoPresentationName()).isEmpty();
        change(new EditName("Rib rotation", "1", "1.2"), "rib_rotation=1.2");
        history.retract(failed);
        assertThat(history.undoPresentationName()).hasValue("Undo Rib rotation 1 -> 1.2");
    }

    @Test
    void aChangeThatCouldNotBeMadeIsForgottenBelowALaterOne() {
        UndoableEdit failed = history.add(EditName.of("Open scan"), List.of(), () -> {}, () -> {});
        change(new EditName("Rib rotation", "1", "1.2"), "rib_rotation=1.2");
        history.retract(failed);
        history.undo();
        assertThat(scenario.get(RibRotation.RIB_ROTATION)).isEqualTo(1);
        assertThat(history.undoPresentationName()).isEmpty();
        assertThat(history.redoPresentationName()).hasValue("Redo Rib rotation 1 -> 1.2");
    }

    @Test
    void aChangeThatIsMergedIsForgottenWhole() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        UndoableEdit failed = history.add(new EditName("Depth", "1.1", "9"), List.of("depth"), () -> {}, () -> {});
        history.retract(failed);
        assertThat(history.undoPresentationName()).isEmpty();
    }

    @Test
    void whatTheRunHasUndoneCannotBeUndoneAgain() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        change(new EditName("Rib rotation", "1", "1.2"), "rib_rotation=1.2");
        history.retractLast(Set.of("depth"));
        assertThat(history.undoPresentationName()).hasValue("Undo Rib rotation 1 -> 1.2");
        history.retractLast(Set.of("rib_rotation", "hold"));
        assertThat(history.undoPresentationName()).hasValue("Undo Depth 1 -> 1.1");
        change(new EditName("Depth", "1.1", "1.2"), "rate_per_min=22");
        history.undo();
        history.retractLast(Set.of("depth"));
        assertThat(history.undoPresentationName())
                .as("the run has undone an undo")
                .hasValue("Undo Depth 1 -> 1.1");
    }

    @Test
    void anUndoThatCouldNotBeMadeLeavesTheChange() {
        change(new EditName("Depth", "1", "1.1"), "depth=1.1");
        UndoableEdit loaded = history.add(EditName.of("Open scan"), List.of(), () -> {}, () -> {});
        history.undo();
        history.revert(loaded);
        assertThat(history.undoPresentationName()).hasValue("Undo Open scan");
        history.undo();
        history.redo();
        history.revert(loaded);
        assertThat(history.redoPresentationName()).hasValue("Redo Open scan");
        assertThat(scenario.get(Breathing.DEPTH)).as("nothing is carried out").isEqualTo(1.1);
    }

    @Test
    void theHistoryIsBoundedAndTellsItsListeners() {
        AtomicLong told = new AtomicLong();
        history.addListener(told::incrementAndGet);
        for (int i = 0; i < EditHistory.MAX_EDITS + 50; i++) {
            change(EditName.of("Depth"), "depth=" + (1 + i % 2));
            pass(LONG_NS);
        }
        int undone = 0;
        while (history.undoPresentationName().isPresent()) {
            history.undo();
            undone++;
        }
        assertThat(undone).isEqualTo(EditHistory.MAX_EDITS);
        assertThat(told).hasValue(2L * EditHistory.MAX_EDITS + 50);
        history.undo();
        assertThat(told).hasValue(2L * EditHistory.MAX_EDITS + 50);
    }
}
