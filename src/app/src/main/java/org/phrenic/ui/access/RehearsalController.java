package org.phrenic.ui.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.live.LiveRehearsal;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scene.AccessMapField;
import org.phrenic.scene.BodySection;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/**
 * Rehearses liver access on the body in the window: records the first breath of the run, computes the access map in the
 * background, and then puts a needle into the run. Used on the event dispatch thread, which never waits.
 */
public final class RehearsalController implements Session.Listener {
    /** Events of a rehearsal. */
    public interface Listener {
        /** Stage, target, entry or advice has changed. */
        default void onState() {}

        /** An attempt begins. */
        default void onAttemptStarted() {}

        /** An attempt has ended and its report is there. */
        default void onAttemptEnded(Rehearsal rehearsal) {}

        /** Another ultrasound image; empty when the probe is lifted. */
        default void onUltrasound(Optional<UltrasoundShot> shot) {}

        /** Another X-ray picture. */
        default void onFluoroscopy(FluoroscopyShot shot) {}

        /** Other sections. */
        default void onSections(BodySection along, BodySection across) {}
    }

    private final Session session;
    private final AppearanceModel appearance;
    private final SceneViewport view;
    private final BackgroundWorker worker = new BackgroundWorker("phrenic-rehearsal");
    final RehearsalPreparation preparation;
    final AttemptRunner attempt;
    private final EntrySelection entrySelection;
    private final PickMode pickMode;
    private final NeedleController needle;
    private final ProbeController probe = new ProbeController(this);
    private final GuidanceSettings pictures = new GuidanceSettings();
    private final EntryView entryView;
    boolean awaitsScene;

    private final List<Listener> listeners = new ArrayList<>();
    RehearsalStage stage = RehearsalStage.CLOSED;
    String unavailableReason = "";
    double recordedFraction;
    Optional<RehearsalBody> body = Optional.empty();
    Optional<RehearsalPlan> exercise = Optional.empty();
    Optional<RehearsalPlan> plan = Optional.empty();
    Optional<TargetAccess> study = Optional.empty();
    Optional<AccessMapField> colours = Optional.empty();

    public RehearsalController(Session session, AppearanceModel appearance, SceneViewport view) {
        this.session = session;
        this.appearance = appearance;
        this.view = view;
        entryView = new EntryView(view);
        preparation = new RehearsalPreparation(session, worker, this);
        attempt = new AttemptRunner(session, worker, this);
        entrySelection = new EntrySelection(session, this, worker);
        pickMode = new PickMode(session, this, view);
        needle = new NeedleController(session, this, view);
        view.setTool(Optional.of(pickMode));
        session.setOfUser(preparation::ofUser);
        session.addListener(this);
    }

    /** Starts rehearsing on the present body; does nothing if it is active. */
    public void activate() {
        if (!isActive()) {
            stage = RehearsalStage.LOADING;
            session.returnToLive();
            awaitsScene = session.live().showOrgans();
            view.setMarkSource(() -> state().map(state ->
                    new NeedleMarkers(state, entrySelection.levelNow(state), pictures.isSeeThrough())));
            session.scene().filter(scene -> !awaitsScene).ifPresentOrElse(this::setBody, this::fireState);
        }
    }

    /** Ends rehearsing; the body breathes on. */
    public void deactivate() {
        if (isActive()) {
            stage = RehearsalStage.CLOSED;
            preparation.endRepetition();
            pickMode.toggle(PickMode.Kind.NONE);
            detachRun();
            session.restoreSpeed();
            view.setMarkSource(Optional::empty);
            appearance.overrideStyle(style -> style, Optional.empty());
        }
    }

    /** Stops observing the run; results of background tasks are discarded. */
    void detachRun() {
        session.live().stopListening();
        worker.discardPending();
        attempt.detach();
    }

    public void shutdown() {
        detachRun();
        worker.close();
        attempt.close();
    }

    @Override
    public void onLoading(String what, double share) {
        awaitsScene |= isActive();
        if (isActive() && stage != RehearsalStage.LOADING) {
            preparation.awaitBody();
        }
    }

    @Override
    public void onScene(LiveScene scene) {
        if (isActive()) {
            setBody(scene);
        }
    }

    @Override
    public void onChange() {
        if (isActive() && awaitsScene && !session.live().isSceneComing(session.scene())) {
            loadingEnded();
        }
        preparation.recordBreathIfChanged();
    }

    /** Loading was cancelled or has failed: the rehearsal goes on with the present body. */
    private void loadingEnded() {
        if (session.live().hasOrgans()) {
            session.scene().ifPresent(this::setBody);
        } else {
            awaitsScene = false;
            stage = RehearsalStage.UNAVAILABLE;
            unavailableReason = "The organs of this body are not loaded; end the rehearsal and begin it again.";
            fireState();
        }
    }

    private void setBody(LiveScene scene) {
        awaitsScene = false;
        entryView.show(scene);
        probe.forget();
        preparation.setBody(scene);
    }

    /** Starts an attempt from the start of the run: by hand, or by the steps of the exercise. */
    void startAttempt(boolean played) {
        detachRun();
        stage = played ? RehearsalStage.PLAYING : RehearsalStage.READY;
        RehearsalPlan steps = (played ? exercise : plan).orElseThrow();
        attempt.start(body.orElseThrow(), study.orElseThrow(), steps, played, entrySelection.chosen());
        fire(Listener::onAttemptStarted);
        fireState();
    }

    /** The steps of an attempt have ended. */
    void onAttemptEnded(boolean played) {
        if (played) {
            stage = RehearsalStage.READY;
            fireState();
        }
    }

    void onReport(Rehearsal report) {
        fire(listener -> listener.onAttemptEnded(report));
        fireState();
    }

    /** Practises on the present body. */
    public void startPractice() {
        preparation.startPractice();
    }

    public void open(RehearsalPlan other) {
        preparation.open(other);
    }

    /** Whether a needle moved by hand is in the body. */
    public boolean isAttemptUnderWay() {
        return stage == RehearsalStage.READY && attempt.isUnderWay();
    }

    /** Starts again with the same target and entry. */
    public void retry() {
        if (study.isPresent() && stage.canStartAttempt()) {
            startAttempt(false);
        }
    }

    public void playExample() {
        if (exercise.isPresent() && study.isPresent() && stage.canStartAttempt()) {
            entrySelection.clear();
            startAttempt(true);
        }
    }

    /** Makes a lesion that the body shows the target. */
    public void setTarget(ScannedLesion lesion) {
        preparation.setTarget(lesion.target());
    }

    /** For picks of a place for needle or probe: the skin about the liver alone, whatever lies before it. */
    ToDoubleFunction<Surface> skinOpacity() {
        Optional<Surface> skin = body.map(b -> b.planningScene().skin().surface());
        return surface -> skin.filter(surface::equals).isPresent() ? 1 : 0;
    }

    /** The lesions of the liver that the body shows, the largest first. */
    public List<ScannedLesion> lesions() {
        return body.map(RehearsalBody::lesions).orElse(List.of());
    }

    public void setTargetMm(double diameterMm) {
        preparation.setTargetMm(diameterMm);
    }

    public NeedleController needle() {
        return needle;
    }

    public ProbeController probe() {
        return probe;
    }

    /** Latency of the images and what is shown of the body. */
    public GuidanceSettings pictures() {
        return pictures;
    }

    /** Shows more or less of the body. */
    public void setAids(Aids shown) {
        pictures.setAids(shown);
        showBody();
        fireState();
    }

    /** Shows the whole body as the aids have it: see-through with its access map, or from outside. */
    void showBody() {
        if (!pictures.isSeeThrough() && body.isPresent()) {
            List<Surface> surfaces = body.get().scene().surfaces();
            appearance.overrideStyle(style -> NeedleMarkers.fromOutside(style, surfaces), Optional.empty());
        } else {
            colours.ifPresentOrElse(
                    map -> appearance.overrideStyle(map::applyTo, colours),
                    () -> appearance.overrideStyle(style -> style.withClip(Optional.empty()), Optional.empty()));
        }
    }

    void note(String sentence) {
        session.note(sentence);
    }

    public EntrySelection entrySelection() {
        return entrySelection;
    }

    /** What the next click in the view chooses. */
    public PickMode pickMode() {
        return pickMode;
    }

    /** The needle in the run; empty unless it may be used. */
    Optional<LiveRehearsal> usableNeedle() {
        return stage == RehearsalStage.READY ? attempt.rehearsal() : Optional.empty();
    }

    /** State of the needle in the run; empty before the first frame. On any thread. */
    public Optional<NeedleState> state() {
        return attempt.state();
    }

    public void addListener(Listener listener) {
        listeners.add(listener);
    }

    public void removeListener(Listener listener) {
        listeners.remove(listener);
    }

    void fire(Consumer<Listener> event) {
        listeners.forEach(event);
    }

    void fireState() {
        fire(Listener::onState);
    }

    public RehearsalStage stage() {
        return stage;
    }

    public boolean isActive() {
        return stage != RehearsalStage.CLOSED;
    }

    public String unavailableReason() {
        return unavailableReason;
    }

    public double recordedFraction() {
        return recordedFraction;
    }

    /** The exercise; empty for practice. */
    public Optional<RehearsalPlan> exercise() {
        return exercise;
    }

    /** What is rehearsed, exercise or practice. */
    public Optional<RehearsalPlan> plan() {
        return plan;
    }

    /** The target and its access map; empty until it is computed. */
    public Optional<TargetAccess> study() {
        return study;
    }
}
