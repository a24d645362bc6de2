package org.phrenic.ui.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.LiveRehearsal;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scene.BodySection;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/**
 * The clinician's door: what is rehearsed on the body that breathes in the window. It has the run's first breath looked
 * at, the access map worked out beside the window, and then puts a needle into the run that does what is asked. On the
 * event dispatch thread; nothing here waits.
 */
public final class RehearsalController implements Session.Listener {
    /** Liver access is from the right. */
    private static final double INITIAL_AZIMUTH_DEG = -52;

    private static final double INITIAL_ELEVATION_DEG = 6;

    private final Session session;
    private final AppearanceModel appearance;
    private final SceneViewport view;
    private final List<RehearsalListener> listeners = new ArrayList<>();
    private final BackgroundWorker worker = new BackgroundWorker("phrenic-rehearsal");
    private final ObservedRun run;
    private final TargetSelection targets = new TargetSelection();
    private final RehearsalPreparation preparation;
    private final AttemptRunner attempt;
    private final EntrySelection entrySelection;
    private final PickMode pickMode;
    private final NeedleController needle;
    private boolean cameraPlaced;

    public RehearsalController(Session session, AppearanceModel looks, SceneViewport view) {
        this.session = session;
        this.appearance = looks;
        this.view = view;
        run = new ObservedRun(session);
        preparation = new RehearsalPreparation(session, looks, worker, run, targets, new PreparationListener());
        attempt = new AttemptRunner(session, run, worker, new AttemptListener());
        entrySelection = new EntrySelection(session, this, worker);
        pickMode = new PickMode(session, this, view);
        needle = new NeedleController(session, this, view);
        view.setTool(Optional.of(new NeedleTool(this)));
        session.addListener(this);
    }

    public void addListener(RehearsalListener listener) {
        listeners.add(listener);
    }

    /** Forgets a listener. */
    public void removeListener(RehearsalListener listener) {
        listeners.remove(listener);
    }

    /** Tells all listeners that something is no longer what it was. */
    void fireState() {
        listeners.forEach(RehearsalListener::onState);
    }

    /** Someone comes in. */
    public void open() {
        if (!isActive()) {
            preparation.setStage(RehearsalStage.LOADING);
            session.returnToLive();
            view.setMarkSource(
                    () -> attempt.state().map(state -> new NeedleMarkers(state, entrySelection.levelNow(state))));
            session.scene().ifPresentOrElse(this::setBody, this::fireState);
        }
    }

    /** Someone goes to the other door; the body breathes on. */
    public void deactivate() {
        if (isActive()) {
            preparation.setStage(RehearsalStage.CLOSED);
            pickMode.toggle(PickMode.Kind.NONE);
            detachRun();
            run.restoreUserSpeed();
            view.setMarkSource(Optional::empty);
            appearance.overrideStyle(style -> style, Optional.empty());
        }
    }

    public boolean isActive() {
        return stage() != RehearsalStage.CLOSED;
    }

    private void detachRun() {
        run.stopObserving();
        worker.discardPending();
        attempt.detach();
    }

    /** Ends its threads. */
    public void shutdown() {
        detachRun();
        worker.close();
        attempt.close();
    }

    @Override
    public void onLoading(String what, double howFar) {
        if (isActive() && stage() != RehearsalStage.LOADING) {
            preparation.onBodyLoading();
        }
    }

    @Override
    public void onScene(LiveScene now) {
        if (isActive()) {
            setBody(now);
        }
    }

    @Override
    public void onChange() {
        preparation.recordBreathIfChanged();
    }

    private void setBody(LiveScene now) {
        if (!cameraPlaced) {
            cameraPlaced = true;
            // The view has taken the scene over by then.
            SwingUtilities.invokeLater(() -> view.setCamera(
                    view.camera().withView(AnatomicalView.ANTERIOR).orbit(INITIAL_AZIMUTH_DEG, INITIAL_ELEVATION_DEG)));
        }
        preparation.setBody(now);
    }

    /** A new attempt from the start of the run; by hand, or by the steps of the exercise. */
    private void startAttempt(boolean played) {
        detachRun();
        preparation.setStage(played ? RehearsalStage.PLAYING : RehearsalStage.READY);
        attempt.start(
                body().orElseThrow(),
                study().orElseThrow(),
                (played ? exercise() : plan()).orElseThrow(),
                played,
                entrySelection.entry());
        listeners.forEach(RehearsalListener::onAttemptStarted);
        fireState();
    }

    /** Practises on the body as it is. */
    public void startPractice() {
        preparation.startPractice();
    }

    /** Opens an exercise: its body breathes as it says, and its target is there. */
    public void open(RehearsalPlan other) {
        preparation.open(other);
    }

    /** From the start again, with the same target and entry. */
    public void retry() {
        if (study().isPresent() && stage().canStartAttempt()) {
            startAttempt(false);
        }
    }

    /** Plays the exercise as it ships. */
    public void playExample() {
        if (exercise().isPresent() && study().isPresent() && stage().canStartAttempt()) {
            entrySelection.clear();
            startAttempt(true);
        }
    }

    /** A target behind the place of the liver that was clicked on. */
    void setTargetBehind(PickResult pick) {
        preparation.computeMap(targets.belowSurface(body().orElseThrow(), pick));
    }

    /** Another size of the target, in the same place. */
    public void setTargetMm(double diameterMm) {
        targets.setDiameterMm(diameterMm);
        if (stage() == RehearsalStage.READY && exercise().isEmpty() && study().isPresent()) {
            preparation.computeMap(targets.resized(body().orElseThrow()));
        }
    }

    /** What moves the needle. */
    public NeedleController needle() {
        return needle;
    }

    /** Where the needle goes in. */
    public EntrySelection entrySelection() {
        return entrySelection;
    }

    /** What clicks choose. */
    public PickMode pickMode() {
        return pickMode;
    }

    /** The needle in the run; empty unless it may be used. */
    Optional<LiveRehearsal> usableNeedle() {
        return stage() == RehearsalStage.READY ? attempt.rehearsal() : Optional.empty();
    }

    public RehearsalStage stage() {
        return preparation.stage();
    }

    /** What is said of a body on which nothing can be rehearsed. */
    public String unavailableReason() {
        return preparation.unavailableReason();
    }

    /** How much of the breath was looked at. */
    public double recordedFraction() {
        return preparation.recordedFraction();
    }

    public Optional<RehearsalPlan> exercise() {
        return targets.exercise();
    }

    /** What is rehearsed, exercise or practice. */
    public Optional<RehearsalPlan> plan() {
        return targets.plan();
    }

    Optional<RehearsalBody> body() {
        return preparation.body();
    }

    public Optional<TargetAccess> study() {
        return targets.study();
    }

    public Optional<NeedleState> state() {
        return attempt.state();
    }

    /** What the preparation wants done with the rest of the door. */
    private final class PreparationListener implements RehearsalPreparation.Listener {
        @Override
        public void detachRun() {
            RehearsalController.this.detachRun();
        }

        @Override
        public void clearEntry() {
            entrySelection.clear();
        }

        @Override
        public void onChange() {
            fireState();
        }

        @Override
        public void onReady() {
            startAttempt(false);
        }
    }

    /** What an attempt tells goes to whom it may concern. */
    private final class AttemptListener implements AttemptRunner.Listener {
        @Override
        public void onRefused(String sentence) {
            session.refuse(sentence);
        }

        @Override
        public void onSections(BodySection along, BodySection across) {
            listeners.forEach(l -> l.onSections(along, across));
        }

        @Override
        public void onEnded(boolean played) {
            if (played) {
                preparation.setStage(RehearsalStage.READY);
                fireState();
            }
        }

        @Override
        public void onReport(Rehearsal rehearsal) {
            listeners.forEach(l -> l.onAttemptEnded(rehearsal));
            fireState();
        }
    }
}
