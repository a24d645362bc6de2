package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.StepListener;

/** The first scene, openings, and looking back at recorded frames, over a small scene. */
class SessionTest {
    private static final long PATIENCE_S = 60;
    /** Longer than any test waits, s. */
    private static final long PICTURE_S = 600;

    private static final Scenario SMALL =
            Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "lungs=off", "sternum=off", "liver=false");

    @TempDir
    Path folder;

    private static Session running() {
        Session session = EventThread.get(() -> new Session(SMALL));
        EventThread.until("a scene", () -> session.scene().isPresent());
        return session;
    }

    @Test
    void anOpeningThatFailsCannotBeUndone() {
        try (Session session = running()) {
            AtomicReference<String> refused = new AtomicReference<>("");
            EventThread.run(() -> {
                session.addListener(new MessageListener(refused::set));
                session.open(EditName.of("Open nothing"), SMALL.with("anatomy=" + folder));
                assertThat(session.edits().undoPresentationName()).hasValue("Undo Open nothing");
            });
            EventThread.until("a refusal", () -> !refused.get().isEmpty());
            EventThread.run(
                    () -> assertThat(session.edits().undoPresentationName()).isEmpty());
        }
    }

    /** The opening has failed, which the window is yet to learn, when a change is made whose scene loads. */
    @Test
    void anOpeningThatFailsIsForgottenThoughAnotherSceneLoadsMeanwhile() {
        try (Session session = running()) {
            EventThread.run(() -> {
                session.open(EditName.of("Open nothing"), SMALL.with("anatomy=" + folder));
                waitWhileLoading(session);
                change(session, "resolution", "medium");
            });
            // What was sent before the change has come.
            EventThread.run(() -> {
                assertThat(session.edits().undoPresentationName()).hasValue("Undo resolution");
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).isEmpty();
            });
            EventThread.until("the values", () -> "low".equals(value(session, "resolution")));
        }
    }

    @Test
    void whyTheFirstBodyCannotBeLoadedIsSaidToThoseWhoListenLater() {
        AtomicReference<String> refused = new AtomicReference<>("");
        try (Session session = EventThread.get(() -> new Session(SMALL.with("anatomy=" + folder)))) {
            EventThread.until("the end of loading", () -> !session.live().isLoading());
            // What the loading has sent comes before this.
            EventThread.run(() -> session.addListener(new MessageListener(refused::set)));
            EventThread.until("a refusal", () -> refused.get().contains(folder.toString()));
        }
    }

    /** The scene that runs, and how far it is. */
    private record Run(long scene, double timeS) {
        static Run of(Session session) {
            return EventThread.get(() -> new Run(
                    session.scene().orElseThrow().id(), session.live().status().timeS()));
        }

        void assertGoesOn(Session session) {
            Run now = of(session);
            assertThat(now.scene()).isEqualTo(scene);
            assertThat(now.timeS()).isGreaterThanOrEqualTo(timeS);
            assertThat(session.live().isPlaying()).isTrue();
        }
    }

    private static void change(Session session, String key, String value) {
        session.change(EditName.of(key), Assignment.read("test", key, value));
    }

    @Test
    void aChangeThatDoesNotGoWithTheOtherSettingsIsRefusedInOneSentence() {
        try (Session session = running()) {
            List<String> said = new ArrayList<>();
            EventThread.run(() -> {
                session.addListener(new MessageListener(said::add));
                change(session, "node_mass_kg", "0.1");
                assertThat(session.edits().undoPresentationName()).isEmpty();
            });
            assertThat(said).singleElement().asString().contains("node_mass_kg", "expected it with material");
        }
    }

    @Test
    void aBreathThatIsImpossibleIsRefusedAndLeavesNothingToUndo() {
        try (Session session = running()) {
            List<String> said = new ArrayList<>();
            EventThread.run(() -> {
                session.addListener(new MessageListener(said::add));
                change(session, "preset", "sniff");
                change(session, "inspiratory_fraction", "0.45");
                assertThat(session.edits().undoPresentationName()).hasValue("Undo preset");
                session.edits().undo();
                assertThat(session.scenario().preset()).isEqualTo("quiet");
            });
            assertThat(said).singleElement().asString().contains("preset sniff", "inspiratory fraction");
        }
    }

    /** With all its meshes, also after others are opened. */
    @Test
    void theFirstBodyIsNotKeptOnceASceneRuns() {
        try (Session session = running()) {
            assertThat(session.firstBody()).isEmpty();
            EventThread.run(() -> session.open(EditName.of("Again"), SMALL));
            long first = EventThread.get(() -> session.scene().orElseThrow().id());
            EventThread.until(
                    "another scene", () -> session.scene().orElseThrow().id() != first);
            assertThat(session.firstBody()).isEmpty();
        }
    }

    /** So that another preset breathes at its own rate again. */
    @Test
    void whatThePresetGivesIsGivenByItAgainAfterUndo() {
        try (Session session = running()) {
            for (String change : List.of("rate_per_min=20", "inspiratory_fraction=0.3", "chest_share=0.7")) {
                EventThread.run(() -> {
                    Scenario before = session.scenario();
                    session.change(EditName.of(change), Assignment.parse(change));
                    assertThat(session.scenario()).isNotEqualTo(before);
                    session.edits().undo();
                    assertThat(session.scenario()).isEqualTo(before);
                    assertThat(session.scenario().statedMap()).isEqualTo(before.statedMap());
                });
            }
        }
    }

    private static Object value(Session session, String key) {
        return session.scenario().toMap().get(key);
    }

    @Test
    void nothingIsLeftToUndoOfLoadingsThatAreCancelled() {
        try (Session session = running()) {
            EventThread.run(() -> {
                change(session, "resolution", "medium");
                change(session, "depth", "1.5");
                change(session, "anatomy", "virtual/adult-female");
                assertThat(session.edits().undoPresentationName()).hasValue("Undo anatomy");
                session.cancelLoading();
                assertThat(session.edits().undoPresentationName()).hasValue("Undo depth");
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).isEmpty();
            });
            EventThread.until("the values", () -> "low".equals(value(session, "resolution")));
        }
    }

    /** Undo of the second change would set what the material that runs has no use for. */
    @Test
    void aChangeForAMaterialWhoseLoadingIsCancelledIsForgottenWithIt() {
        try (Session session = running()) {
            EventThread.run(() -> {
                change(session, "depth", "1.5");
                change(session, "material", "paper");
                change(session, "muscle_force_mn", "20");
                change(session, "rib_rotation", "0.9");
                session.cancelLoading();
                assertThat(session.edits().undoPresentationName()).hasValue("Undo rib_rotation");
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).hasValue("Undo depth");
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).isEmpty();
            });
            EventThread.until("the values", () -> session.scenario().equals(SMALL));
        }
    }

    /** The scene of a first change runs, which the window is yet to learn, when a second change is made. */
    @Test
    void aCancelledChangeIsForgottenThoughTheSceneOfAnEarlierOneCameMeanwhile() {
        try (Session session = running()) {
            EventThread.run(() -> {
                change(session, "links_per_node", "2");
                assertThat(session.live().isLoading()).isTrue();
                waitWhileLoading(session);
                change(session, "resolution", "medium");
            });
            // What was sent before the second change has come.
            EventThread.run(() -> {
                session.cancelLoading();
                assertThat(session.edits().undoPresentationName()).hasValue("Undo links_per_node");
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).isEmpty();
            });
        }
    }

    private static void waitWhileLoading(Session session) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        while (session.live().isLoading()) {
            assertThat(System.nanoTime()).as("patience").isLessThan(end);
            Thread.onSpinWait();
        }
        // Answered when the scene runs and that is sent.
        session.live().recordedScenario();
    }

    @Test
    void anUndoWhileItsSceneLoadsLeavesTheRunAsItIs() {
        try (Session session = running()) {
            Run before = Run.of(session);
            EventThread.run(() -> {
                change(session, "resolution", "medium");
                session.edits().undo();
                assertThat(session.live().isLoading()).isFalse();
                assertThat(session.edits().redoPresentationName()).hasValue("Redo resolution");
            });
            EventThread.until("the value", () -> "low".equals(value(session, "resolution")));
            before.assertGoesOn(session);
            EventThread.run(() -> {
                session.open(EditName.of("Open a file"), SMALL.with("anatomy=virtual/adult-female"));
                session.edits().undo();
                assertThat(session.live().isLoading()).isFalse();
            });
            before.assertGoesOn(session);
            EventThread.run(session.edits()::redo);
            EventThread.until("the scene", () -> session.scene().orElseThrow().id() != before.scene());
        }
    }

    @Test
    void anUndoOfOneOfTwoLoadingsLeavesTheOther() {
        try (Session session = running()) {
            long first = EventThread.get(() -> session.scene().orElseThrow().id());
            EventThread.run(() -> {
                change(session, "rib_rotation", "0.9");
                change(session, "resolution", "medium");
                change(session, "anatomy", "virtual/adult-female");
                session.edits().undo();
                assertThat(session.live().isLoading()).isTrue();
            });
            EventThread.until("the scene", () -> session.scene().orElseThrow().id() != first);
            assertThat(EventThread.get(() -> value(session, "resolution"))).isEqualTo("medium");
            assertThat(EventThread.get(() -> value(session, "anatomy"))).isEqualTo("virtual/adult-male");
            assertThat(EventThread.get(() -> session.edits().undoPresentationName()))
                    .hasValue("Undo resolution");
        }
    }

    @Test
    void anUndoWhoseSceneIsNotWantedIsNone() {
        try (Session session = running()) {
            long first = EventThread.get(() -> session.scene().orElseThrow().id());
            EventThread.run(() -> change(session, "resolution", "medium"));
            EventThread.until("the scene", () -> session.scene().orElseThrow().id() != first);
            EventThread.run(() -> {
                session.edits().undo();
                assertThat(session.edits().undoPresentationName()).isEmpty();
                session.cancelLoading();
                assertThat(session.edits().undoPresentationName()).hasValue("Undo resolution");
            });
            EventThread.until("the value", () -> "medium".equals(value(session, "resolution")));
        }
    }

    @Test
    void ofTwoFilesThatAreOpenedInSuccessionTheSecondCounts() throws IOException {
        Path first =
                Files.writeString(folder.resolve("first.yaml"), "name: first\nresolution: low\nmesh_vertices: 2000\n");
        Path second = Files.writeString(
                folder.resolve("second.yaml"), "name: second\nresolution: low\nmesh_vertices: 2000\n");
        try (Session session = running()) {
            List<Path> opened = new ArrayList<>();
            EventThread.run(() -> {
                session.addListener(new Session.Listener() {
                    @Override
                    public void onOpened(Path file, Scenario scenario) {
                        opened.add(file);
                    }
                });
                session.openFile(first);
                session.openFile(second);
            });
            EventThread.until("the second file", () -> opened.contains(second));
            EventThread.run(() -> assertThat(opened).containsExactly(second));
        }
    }

    @Test
    void whereThePastIsShownNoMoreIsSaid() {
        try (Session session = running()) {
            AtomicReference<String> shown = new AtomicReference<>("");
            EventThread.run(() -> {
                session.showHistoryFrame(0);
                session.addListener(new Session.Listener() {
                    @Override
                    public void onScrub() {
                        shown.set(session.historyFrame().isPresent() ? "recorded" : "present");
                    }
                });
                session.open(EditName.of("Stiffer"), SMALL.with("rib_rotation=0.5"));
            });
            EventThread.until("the present", () -> shown.get().equals("present"));
        }
    }

    /** As a rehearsal begins an attempt again. */
    @Test
    void aRunThatBeginsAgainWhereThePastWasShownIsShownInThePresentAndCanBePaused() {
        try (Session session = running()) {
            EventThread.run(() -> {
                session.togglePlay();
                session.showHistoryFrame(0);
                session.restart(StepListener.Trigger.every(1), (frame, label) -> {});
                assertThat(session.historyFrame()).isEmpty();
                assertThat(session.live().isPlaying()).isTrue();
                session.togglePlay();
                assertThat(session.live().isPlaying()).isFalse();
            });
        }
    }

    @Test
    void anotherSceneGoesOnWhereThePastWasShownOfOneThatRan() {
        try (Session session = running()) {
            long first = EventThread.get(() -> session.scene().orElseThrow().id());
            EventThread.run(() -> {
                session.showHistoryFrame(0);
                session.open(EditName.of("Stiffer"), SMALL.with("rib_rotation=0.5"));
            });
            EventThread.until(
                    "another scene", () -> session.scene().orElseThrow().id() != first);
            assertThat(session.live().isPlaying()).isTrue();
            assertThat(EventThread.get(session::historyFrame)).isEmpty();
        }
    }

    /** A rehearsal repeats steady breaths for itself alone. */
    @Test
    void undoDoesNotBringBackWhatAPartOfTheWindowHadSetForItself() {
        try (Session session = running()) {
            long first = EventThread.get(() -> session.scene().orElseThrow().id());
            EventThread.run(() -> {
                session.setOfUser(scenario -> scenario.without(Breathing.REPEAT));
                change(session, "rib_rotation", "0.9");
                session.live().change(List.of(Assignment.of("test", Breathing.REPEAT, true)));
            });
            EventThread.until("the setting", () -> session.scenario().get(Breathing.REPEAT));
            EventThread.run(() -> session.open(EditName.of("Stiffer"), SMALL.with("rib_rotation=0.5")));
            EventThread.until(
                    "another scene", () -> session.scene().orElseThrow().id() != first);
            EventThread.run(session.edits()::undo);
            EventThread.until("the value", () -> Double.valueOf(0.9).equals(value(session, "rib_rotation")));
            assertThat(EventThread.get(() -> session.scenario().get(Breathing.REPEAT)))
                    .isFalse();
        }
    }

    @Test
    void oneStepFromThePastIsAStepFromThePresent() {
        try (Session session = running()) {
            EventThread.run(() -> session.showHistoryFrame(0));
            // What was asked before is done when this is answered.
            long before = session.live().recordedScenario().steps();
            EventThread.run(session::stepOnce);
            assertThat(session.live().recordedScenario().steps()).isEqualTo(before + 1);
            assertThat(session.live().isPlaying()).isFalse();
            assertThat(EventThread.get(session::historyFrame)).isEmpty();
        }
    }

    /** Whether a thread sleeps until there is a picture. */
    private static boolean isPictureAwaited() {
        return Thread.getAllStackTraces().entrySet().stream()
                .filter(thread -> thread.getKey().getState() == Thread.State.TIMED_WAITING)
                .flatMap(thread -> Arrays.stream(thread.getValue()))
                .anyMatch(call -> call.getClassName().equals(FirstPicture.class.getName()));
    }

    @Test
    void theFirstSceneWaitsForTheFirstPicture() throws Exception {
        CountDownLatch body = new CountDownLatch(1);
        CountDownLatch scene = new CountDownLatch(1);
        Session[] made = new Session[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = new Session(SMALL, new FirstPicture(true, PICTURE_S));
            made[0].addListener(new Session.Listener() {
                @Override
                public void onBody(LiveScene atRest) {
                    body.countDown();
                }

                @Override
                public void onScene(LiveScene running) {
                    scene.countDown();
                }
            });
        });
        try (Session session = made[0]) {
            assertThat(body.await(PATIENCE_S, TimeUnit.SECONDS))
                    .as("a body to draw")
                    .isTrue();
            EventThread.until("a wait for the picture", () -> isPictureAwaited() || scene.getCount() == 0);
            assertThat(scene.getCount()).as("a scene before the picture").isEqualTo(1);
            session.endPictureWait();
            assertThat(scene.await(PATIENCE_S, TimeUnit.SECONDS))
                    .as("a scene after the picture")
                    .isTrue();
        }
    }
}
