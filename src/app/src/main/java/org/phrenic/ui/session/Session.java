package org.phrenic.ui.session;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;

/**
 * What the window and its docks share: the running simulation, its present scene and the events between them.
 * Everything here is called on the event dispatch thread, and every listener is told there; nothing waits for the
 * simulation.
 */
public final class Session implements AutoCloseable {
    /** What a part of the window may want to know of. */
    public interface Listener {
        /** A scene is being built. */
        default void onLoading(String what, double share) {}

        /** A new scene breathes: other surfaces, other nodes, step 0. */
        default void onScene(LiveScene scene) {}

        /** Twenty times a second. */
        default void onTick(RunStatus status) {}

        /** Values of the scenario are no longer what they were, whoever changed them. */
        default void onChange() {}

        /** One sentence for the user. */
        default void onMessage(Message message) {}

        /** Another recorded frame is looked at, or the present again. */
        default void onScrub() {}
    }

    /**
     * One sentence for the user.
     *
     * @param kind how it is shown
     * @param text the sentence
     */
    public record Message(Kind kind, String text) {
        /** How much it matters. */
        public enum Kind {
            /** Worth knowing; goes by itself. */
            NOTE,
            /** What was asked for was not done. */
            REFUSED,
            /** The simulation diverged and stands still. */
            DIVERGED
        }
    }

    private static final int TICK_MS = 50;

    private final List<Listener> listeners = new CopyOnWriteArrayList<>();
    private final EditHistory edits = new EditHistory(this::applyStep);
    private final LiveRun live;
    private final Timer tickTimer;
    private LiveScene scene;
    private Scenario requested;
    private int historyFrame = -1;
    private boolean resumeAfterHistory;
    private double speed = 1;

    /** Starts to load a scenario, and to play it once it is there. */
    public Session(Scenario first) {
        requested = first;
        live = new LiveRun(first, new RunListener());
        live.play();
        tickTimer = new Timer(TICK_MS, e -> fire(l -> l.onTick(live.status())));
        tickTimer.start();
    }

    /** Tells {@code listener} of everything from now on; of the present scene at once. */
    public void addListener(Listener listener) {
        listeners.add(listener);
        if (scene != null) {
            listener.onScene(scene);
        }
    }

    /** Forgets a listener. */
    public void removeListener(Listener listener) {
        listeners.remove(listener);
    }

    /** The simulation, for play, pause, step, speed, history and frames. Changes go through {@link #change}. */
    public LiveRun live() {
        return live;
    }

    /** What was changed by hand, to undo and redo. */
    public EditHistory edits() {
        return edits;
    }

    /** The scene that breathes; empty until the first one is there. */
    public Optional<LiveScene> scene() {
        return Optional.ofNullable(scene);
    }

    /** The values as now set; before the first scene is there, those asked for. */
    public Scenario scenario() {
        return scene == null ? requested : live.scenario();
    }

    /**
     * Changes values by hand. What is wrong with them is said in a message, and then nothing changes.
     *
     * @param name of the change for people, as in "Undo Damping 12"
     */
    public void change(String name, Assignment... assignments) {
        List<Assignment> list = Arrays.asList(assignments);
        Scenario before = scenario();
        try {
            Scenario after = before.with(list);
            live.change(list);
            requested = after;
            edits.add(name, EditHistory.inverse(before, list), new EditHistory.Step.Set(list));
        } catch (IllegalArgumentException e) {
            reportRefusal(e.getMessage());
        }
    }

    /** Puts a whole scenario in the place of the present one. */
    public void open(String name, Scenario scenario) {
        Scenario before = scenario();
        loadScenario(scenario);
        edits.add(name, new EditHistory.Step.Load(before), new EditHistory.Step.Load(scenario));
    }

    private void loadScenario(Scenario scenario) {
        requested = scenario;
        live.load(scenario);
    }

    /** Goes one step back or forth in the history of edits. */
    private void applyStep(EditHistory.Step step) {
        if (step instanceof EditHistory.Step.Set values) {
            requested = scenario().with(values.assignments());
            live.change(values.assignments());
        } else if (step instanceof EditHistory.Step.Load whole) {
            loadScenario(whole.scenario());
        }
    }

    /** Opens a scenario, a thorax folder or a trace; reads it off the event dispatch thread. */
    public void openFile(Path file) {
        Scenario present = scenario();
        new FileReadWorker<>(
                        file,
                        () -> FileOpener.readScenario(file, present),
                        scenario -> open("Open " + file.getFileName(), scenario),
                        this::reportRefusal)
                .execute();
    }

    /** Shows frame {@code index} of the history and stands still meanwhile. */
    public void showHistoryFrame(int index) {
        if (historyFrame < 0) {
            resumeAfterHistory = live.isPlaying();
            live.pause();
        }
        historyFrame = index;
        fire(Listener::onScrub);
    }

    /** Shows the present again, and goes on if it was going before. */
    public void returnToLive() {
        if (historyFrame >= 0) {
            historyFrame = -1;
            if (resumeAfterHistory) {
                live.play();
            }
            fire(Listener::onScrub);
        }
    }

    /** The recorded frame that is looked at; empty for the present. */
    public OptionalInt historyFrame() {
        return historyFrame < 0 ? OptionalInt.empty() : OptionalInt.of(historyFrame);
    }

    /** How fast simulated time may go: what was chosen, whatever is needed for a while. */
    public void setSpeed(double factor) {
        speed = factor;
        live.setSpeed(factor);
    }

    /** As chosen last. */
    public double speed() {
        return speed;
    }

    /** Plays or pauses; leaves a recorded frame for the present. */
    public void togglePlay() {
        if (historyFrame >= 0) {
            resumeAfterHistory = true;
            returnToLive();
        } else if (live.isPlaying()) {
            live.pause();
        } else {
            live.play();
        }
        fire(Listener::onChange);
    }

    /** Tells the user one sentence. */
    public void showMessage(Message.Kind kind, String text) {
        fire(l -> l.onMessage(new Message(kind, text)));
    }

    private void reportRefusal(String sentence) {
        showMessage(Message.Kind.REFUSED, sentence);
        fire(Listener::onChange);
    }

    private void fire(Consumer<Listener> what) {
        listeners.forEach(what);
    }

    /** Ends the simulation. */
    @Override
    public void close() {
        tickTimer.stop();
        live.close();
    }

    /** Carries what the simulation says over to the event dispatch thread. */
    private final class RunListener implements LiveRun.Listener {
        @Override
        public void loading(String what, double share) {
            later(l -> l.onLoading(what, share));
        }

        @Override
        public void ready(LiveScene ready) {
            SwingUtilities.invokeLater(() -> {
                scene = ready;
                historyFrame = -1;
                fire(l -> l.onScene(ready));
                fire(Listener::onChange);
            });
        }

        @Override
        public void failed(String sentence) {
            SwingUtilities.invokeLater(() -> reportRefusal(sentence));
        }

        @Override
        public void diverged(String sentence) {
            later(l -> l.onMessage(new Message(Message.Kind.DIVERGED, sentence)));
        }

        @Override
        public void changed() {
            later(Listener::onChange);
        }

        private void later(Consumer<Listener> what) {
            SwingUtilities.invokeLater(() -> fire(what));
        }
    }
}
