package org.phrenic.ui;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/**
 * What the window and its docks share: the running simulation, its present scene and the events between them. Everything here is called on the event dispatch thread, and every listener is told there; nothing
 * waits for the simulation.
 */
public final class Session implements AutoCloseable {
    /** What a part of the window may want to know of. */
    public interface Events {
        /** A scene is being built. */
        default void onLoading(String what, double share) {}

        /** A new scene breathes: other surfaces, other nodes, step 0. */
        default void onScene(LiveScene scene) {}

        /** Twenty times a second. */
        default void onTick(Status status) {}

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

    private final List<Events> listeners = new CopyOnWriteArrayList<>();
    private final EditHistory edits = new EditHistory(this::retrace);
    private final LiveRun live;
    private final Timer ticks;
    private LiveScene scene;
    private Scenario asked;
    private int scrubbed = -1;
    private boolean playAfterScrub;
    private double speed = 1;

    /** Starts to load a scenario, and to play it once it is there. */
    public Session(Scenario first) {
        asked = first;
        live = new LiveRun(first, new FromSimulation());
        live.play();
        ticks = new Timer(TICK_MS, e -> tell(l -> l.onTick(live.status())));
        ticks.start();
    }

    /** Tells {@code listener} of everything from now on; of the present scene at once. */
    public void listen(Events listener) {
        listeners.add(listener);
        if (scene != null) {
            listener.onScene(scene);
        }
    }

    /** Forgets a listener. */
    public void forget(Events listener) {
        listeners.remove(listener);
    }

    /** The simulation, for play, pause, step, speed, history and frames. Changes go through {@link #change}. */
    public LiveRun live() {
        return live;
    }

    /** What was changed by hand, to undo and redo. */
    EditHistory edits() {
        return edits;
    }

    /** The scene that breathes; empty until the first one is there. */
    public Optional<LiveScene> scene() {
        return Optional.ofNullable(scene);
    }

    /** The values as now set; before the first scene is there, those asked for. */
    public Scenario scenario() {
        return scene == null ? asked : live.scenario();
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
            asked = after;
            edits.record(name, EditHistory.back(before, list), new EditHistory.Step.Set(list));
        } catch (IllegalArgumentException e) {
            refuse(e.getMessage());
        }
    }

    /** Puts a whole scenario in the place of the present one. */
    public void open(String name, Scenario scenario) {
        Scenario before = scenario();
        replace(scenario);
        edits.record(name, new EditHistory.Step.Load(before), new EditHistory.Step.Load(scenario));
    }

    private void replace(Scenario scenario) {
        asked = scenario;
        live.load(scenario);
    }

    /** Goes one step back or forth in the history of edits. */
    private void retrace(EditHistory.Step step) {
        if (step instanceof EditHistory.Step.Set values) {
            asked = scenario().with(values.assignments());
            live.change(values.assignments());
        } else if (step instanceof EditHistory.Step.Load whole) {
            replace(whole.scenario());
        }
    }

    /** Opens a scenario, a thorax folder or a trace; reads it off the event dispatch thread. */
    public void load(Path file) {
        Scenario present = scenario();
        new Reading<>(
                        file,
                        () -> Opening.read(file, present),
                        scenario -> open("Open " + file.getFileName(), scenario),
                        this::refuse)
                .execute();
    }

    /** Shows frame {@code index} of the history and stands still meanwhile. */
    public void scrub(int index) {
        if (scrubbed < 0) {
            playAfterScrub = live.isPlaying();
            live.pause();
        }
        scrubbed = index;
        tell(Events::onScrub);
    }

    /** Shows the present again, and goes on if it was going before. */
    public void follow() {
        if (scrubbed >= 0) {
            scrubbed = -1;
            if (playAfterScrub) {
                live.play();
            }
            tell(Events::onScrub);
        }
    }

    /** The recorded frame that is looked at; empty for the present. */
    public OptionalInt scrubbed() {
        return scrubbed < 0 ? OptionalInt.empty() : OptionalInt.of(scrubbed);
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
        if (scrubbed >= 0) {
            playAfterScrub = true;
            follow();
        } else if (live.isPlaying()) {
            live.pause();
        } else {
            live.play();
        }
        tell(Events::onChange);
    }

    /** Tells the user one sentence. */
    public void say(Message.Kind kind, String text) {
        tell(l -> l.onMessage(new Message(kind, text)));
    }

    private void refuse(String sentence) {
        say(Message.Kind.REFUSED, sentence);
        tell(Events::onChange);
    }

    private void tell(Consumer<Events> what) {
        listeners.forEach(what);
    }

    /** Ends the simulation. */
    @Override
    public void close() {
        ticks.stop();
        live.close();
    }

    /** Carries what the simulation says over to the event dispatch thread. */
    private final class FromSimulation implements LiveRun.Listener {
        @Override
        public void loading(String what, double share) {
            later(l -> l.onLoading(what, share));
        }

        @Override
        public void ready(LiveScene ready) {
            SwingUtilities.invokeLater(() -> {
                scene = ready;
                scrubbed = -1;
                tell(l -> l.onScene(ready));
                tell(Events::onChange);
            });
        }

        @Override
        public void failed(String sentence) {
            SwingUtilities.invokeLater(() -> refuse(sentence));
        }

        @Override
        public void diverged(String sentence) {
            later(l -> l.onMessage(new Message(Message.Kind.DIVERGED, sentence)));
        }

        @Override
        public void changed() {
            later(Events::onChange);
        }

        private void later(Consumer<Events> what) {
            SwingUtilities.invokeLater(() -> tell(what));
        }
    }
}
