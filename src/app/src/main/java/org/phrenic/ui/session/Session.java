package org.phrenic.ui.session;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.live.StepListener;

/**
 * The running simulation, its scene, the history of edits, and the events between them and the parts of the window. All
 * methods are called on the event dispatch thread and none waits for the simulation, except {@link #close}, which waits
 * for the end of a step and may be called on any thread.
 */
public final class Session implements AutoCloseable {
    /** Events of the session, on the event dispatch thread. */
    public interface Listener {
        /** A scene is being built. */
        default void onLoading(String what, double share) {}

        /** The body of the first scene is there; it can be shown at rest until the scene runs. */
        default void onBody(LiveScene atRest) {}

        /** A file was read, and its scenario loads. */
        default void onOpened(Path file, Scenario scenario) {}

        /** A new scene runs: other surfaces, other nodes, step 0. */
        default void onScene(LiveScene scene) {}

        /** Twenty times per second. */
        default void onTick(RunStatus status) {}

        /** Values of the scenario have changed. */
        default void onChange() {}

        /** A change by hand, or its undoing, holds or releases the breath. */
        default void onHoldEdited() {}

        /** A message for the user. */
        default void onMessage(SessionMessage message) {}

        /** Another recorded frame is shown, or the present. */
        default void onScrub() {}
    }

    private static final int TICK_MS = 50;

    private final List<Listener> listeners = new CopyOnWriteArrayList<>();
    private final EditHistory edits = new EditHistory(System::nanoTime);
    private final LiveRun live;
    private final Timer tickTimer;
    private LiveScene scene;
    private LiveScene bodyAtRest;
    private final FirstPicture picture;
    private final EditedScenario edited;
    private final LookingBack lookingBack;
    private final LatestTask opening = new LatestTask();
    private double speed = 1;
    private UnaryOperator<Scenario> ofUser = UnaryOperator.identity();
    private Optional<SessionMessage> firstFailure = Optional.empty();

    public Session(Scenario first) {
        this(first, false);
    }

    /** @param pictureFirst whether the first picture, of the body at rest, comes before the first scene is assembled */
    public Session(Scenario first, boolean pictureFirst) {
        this(first, new FirstPicture(pictureFirst));
    }

    Session(Scenario first, FirstPicture picture) {
        this.picture = picture;
        live = new LiveRun(first, new RunListener());
        edited = new EditedScenario(first, live, edits, this::userScenario, () -> fire(Listener::onHoldEdited));
        lookingBack = new LookingBack(live);
        live.play();
        tickTimer = new Timer(TICK_MS, e -> fire(l -> l.onTick(live.status())));
        tickTimer.start();
    }

    /** To be called when there is a first picture, or when there will be none. */
    public void endPictureWait() {
        picture.endWait();
    }

    /** Adds a listener; it gets the present scene, the body of the first, or why there is none, at once. */
    public void addListener(Listener listener) {
        listeners.add(listener);
        if (scene != null) {
            listener.onScene(scene);
        } else if (bodyAtRest != null) {
            listener.onBody(bodyAtRest);
        }
        firstFailure.filter(f -> scene == null && !live.isLoading()).ifPresent(listener::onMessage);
    }

    public void removeListener(Listener listener) {
        listeners.remove(listener);
    }

    /** The simulation, for play, pause, step, speed, history and frames. Changes go through {@link #change}. */
    public LiveRun live() {
        return live;
    }

    /** The body of the scene that loads first, as soon as it is there and until a scene runs; on any thread. */
    public Optional<LiveScene> firstBody() {
        return picture.body();
    }

    /** Changes made by hand, to undo and redo. */
    public EditHistory edits() {
        return edits;
    }

    /** The scene that runs; empty until the first one is loaded. */
    public Optional<LiveScene> scene() {
        return Optional.ofNullable(scene);
    }

    /** The present values; before the first scene is loaded, the requested ones. */
    public Scenario scenario() {
        return scene == null ? edited.requested() : live.scenario();
    }

    /** The present values without what a part of the window sets for itself: what is saved, and what undo loads. */
    public Scenario userScenario() {
        return ofUser.apply(scenario());
    }

    /** Whether the scenario that was loaded schedules changes, which {@link #userScenario} leaves out. */
    public boolean isScheduled() {
        return edited.isScheduled();
    }

    /** Sets what leaves out of a scenario what a part of the window sets for itself. */
    public void setOfUser(UnaryOperator<Scenario> withoutOwn) {
        ofUser = withoutOwn;
    }

    /** As {@link #change(EditName, Assignment...)}, named by one label. */
    public void change(String label, Assignment... assignments) {
        change(EditName.of(label), assignments);
    }

    /** Changes values by hand; quick changes of the same keys are undone together. Wrong values are only reported. */
    public void change(EditName name, Assignment... assignments) {
        try {
            edited.change(name, List.of(assignments));
        } catch (IllegalArgumentException | BadInputException e) {
            reportRefusal(e.getMessage());
        }
    }

    /** As {@link #change(EditName, Assignment...)}, undone on its own however soon it follows another change. */
    public void changeSeparately(EditName name, List<Assignment> assignments) {
        edits.endMerging();
        change(name, assignments.toArray(Assignment[]::new));
        edits.endMerging();
    }

    /** Loads another scenario, not a file that is being read; the change is forgotten if it fails or is cancelled. */
    public void open(EditName name, Scenario scenario) {
        opening.drop();
        edited.open(name, scenario);
    }

    /** Keeps the scene that runs; without one, that which loads. */
    public void cancelLoading() {
        if (live.cancelLoading()) {
            edited.forgetLoading();
        }
    }

    /** The file that is being read; the one asked for last counts. */
    public LatestTask opening() {
        return opening;
    }

    /** Opens a scenario, a thorax folder or a trace; reads it off the event dispatch thread. */
    public void openFile(Path file) {
        Scenario present = userScenario();
        opening.execute(
                () -> FileOpener.readScenario(file, present),
                scenario -> {
                    open(EditName.of("Open " + file.getFileName()), scenario);
                    fire(l -> l.onOpened(file, scenario));
                },
                this::reportRefusal);
    }

    /** Shows a recorded frame; the simulation is paused meanwhile. */
    public void showHistoryFrame(int index) {
        lookingBack.show(index);
        fire(Listener::onScrub);
    }

    /** Shows the present, and resumes the simulation if it was running before. */
    public void returnToLive() {
        if (lookingBack.end()) {
            fire(Listener::onScrub);
        }
    }

    /** The recorded frame that is shown; empty for the present. */
    public OptionalInt historyFrame() {
        return lookingBack.frame();
    }

    /** Sets the speed of simulated time over real time that the user wants. */
    public void setSpeed(double factor) {
        speed = factor;
        live.setSpeed(factor);
    }

    /** Goes back to the speed that the user wants. */
    public void restoreSpeed() {
        live.setSpeed(speed);
    }

    /** Restarts and runs in the present, without a breath hold; {@code listener} is called after steps. */
    public void restart(StepListener.Trigger when, StepListener listener) {
        if (scenario().hold()) {
            live.change(List.of(Assignment.of("window", Breathing.HOLD, false)));
        }
        live.restart(when, listener);
        returnToLive();
        live.play();
    }

    /** Plays or pauses; leaves a recorded frame for the present. */
    public void togglePlay() {
        if (historyFrame().isEmpty() && live.isPlaying()) {
            live.pause();
        } else {
            returnToLive();
            live.play();
        }
        fire(Listener::onChange);
    }

    /** Pauses in the present, and goes on by one time step. */
    public void stepOnce() {
        lookingBack.stayPaused();
        returnToLive();
        live.pause();
        live.stepOnce();
    }

    /** Shows a sentence that is worth knowing. */
    public void note(String sentence) {
        fire(l -> l.onMessage(new SessionMessage(SessionMessage.Kind.NOTE, sentence)));
    }

    /** Shows a sentence on why something is not done. */
    public void refuse(String sentence) {
        fire(l -> l.onMessage(new SessionMessage(SessionMessage.Kind.REFUSED, sentence)));
    }

    /** Controls that show a value which is not taken go back to the scenario's. */
    private void reportRefusal(String sentence) {
        refuse(sentence);
        fire(Listener::onChange);
    }

    private void fire(Consumer<Listener> what) {
        listeners.forEach(what);
    }

    @Override
    public void close() {
        tickTimer.stop();
        endPictureWait();
        live.close();
    }

    /** Passes the events of the run to the event dispatch thread. */
    private final class RunListener implements LiveRun.Listener {
        @Override
        public void loading(String what, double share) {
            later(l -> l.onLoading(what, share));
        }

        @Override
        public void body(LiveScene atRest) {
            picture.offer(atRest);
            SwingUtilities.invokeLater(() -> {
                if (scene == null) {
                    bodyAtRest = atRest;
                    fire(l -> l.onBody(atRest));
                }
            });
            picture.await();
        }

        @Override
        public void ready(LiveScene ready) {
            SwingUtilities.invokeLater(() -> {
                scene = ready;
                bodyAtRest = null;
                picture.end();
                edited.endLoading(ready.id());
                lookingBack.end();
                fire(l -> l.onScene(ready));
                fire(Listener::onScrub);
                fire(Listener::onChange);
            });
        }

        @Override
        public void failed(String sentence) {
            SwingUtilities.invokeLater(() -> {
                edited.forgetLoading(live.lastFailedSceneId());
                firstFailure = Optional.of(new SessionMessage(SessionMessage.Kind.REFUSED, sentence));
                reportRefusal(sentence);
            });
        }

        @Override
        public void diverged(String sentence) {
            later(l -> l.onMessage(new SessionMessage(SessionMessage.Kind.DIVERGED, sentence)));
        }

        @Override
        public void restored(Set<String> keys) {
            SwingUtilities.invokeLater(() -> edits.retractLast(keys));
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
