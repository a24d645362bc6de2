package org.phrenic.ui;

import java.awt.Cursor;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.phrenic.engine.Workers;
import org.phrenic.rehearsal.BreathCycle;
import org.phrenic.rehearsal.BreathMoment;
import org.phrenic.rehearsal.CycleRecorder;
import org.phrenic.rehearsal.LiveAttempt;
import org.phrenic.rehearsal.LiveRehearsal;
import org.phrenic.rehearsal.MovingScene;
import org.phrenic.rehearsal.Needle;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.rehearsal.PathCycle;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.Target;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.scene.AccessField;
import org.phrenic.scene.NeedleMarks;
import org.phrenic.scene.Pick;
import org.phrenic.scene.Section;
import org.phrenic.scene.View;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Surface;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Watch;

/**
 * The clinician's door: what is rehearsed on the body that breathes in the window. It has the run's first breath looked at, the access map worked out beside the window, and then puts a needle into the run that
 * does what is asked. On the event dispatch thread; nothing here waits.
 */
final class RehearsalDoor implements Session.Events {
    /** How far it is. */
    enum Stage {
        /** Another arrangement is used. */
        CLOSED,
        /** A body is being built. */
        LOADING,
        /** A breath is being looked at. */
        LOOKING,
        /** The access map is being worked out. */
        MAPPING,
        /** The needle may be used. */
        READY,
        /** A plan is being played. */
        SHOWING,
        /** This body has no liver access to rehearse. */
        IMPOSSIBLE
    }

    /** What the next click in the view chooses. */
    enum Choosing {
        NOTHING,
        ENTRY,
        TARGET
    }

    /** What the parts of the door want to know. */
    interface Events {
        /** Stage, target, entry or advice changed. */
        default void onDoor() {}

        /** An attempt begins. */
        default void onBegin() {}

        /** An attempt has ended and its report is there. */
        default void onAttempt(Rehearsal rehearsal) {}

        /** Other sections. */
        default void onSections(Section along, Section across) {}
    }

    private static final double BEHIND_MM = 35;
    /** Liver access is from the right. */
    private static final double FROM_RIGHT_DEG = -52;

    private static final double FROM_ABOVE_DEG = 6;
    private static final double USUAL_TARGET_MM = 20;
    private static final long SEED = 1;

    private final Session session;
    private final Looks looks;
    private final SceneView view;
    private final List<Events> listeners = new ArrayList<>();
    private final Background work = new Background("phrenic-rehearsal");
    private final ExecutorService cutter = Background.thread("phrenic-section");

    private final NeedleHand hand;

    private Stage stage = Stage.CLOSED;
    private Choosing choosing = Choosing.NOTHING;
    private String doing = "";
    private double share;
    private Optional<RehearsalPlan> exercise = Optional.empty();
    private RehearsalPlan plan;
    private double targetMm = USUAL_TARGET_MM;
    private LiveScene scene;
    private Frame ofScene;
    private MovingScene mapped;
    private MovingScene lived;
    private List<BreathMoment> cycle = List.of();
    private Map<String, Object> breathing = Map.of();
    private Optional<TargetStudy> study = Optional.empty();
    private Optional<double[]> entry = Optional.empty();
    private volatile Optional<PathAdvice> advice = Optional.empty();
    private volatile LiveRehearsal rehearsal;

    RehearsalDoor(Session session, Looks looks, SceneView view) {
        this.session = session;
        this.looks = looks;
        this.view = view;
        hand = new NeedleHand(session, this, view);
        view.setTool(Optional.of(new NeedleTool(this)));
        session.listen(this);
    }

    void listen(Events listener) {
        listeners.add(listener);
    }

    /** Forgets a listener. */
    void forget(Events listener) {
        listeners.remove(listener);
    }

    /** Someone comes in. */
    void open() {
        if (stage == Stage.CLOSED) {
            stage = Stage.LOADING;
            session.follow();
            view.mark(this::marks);
            session.scene().ifPresentOrElse(this::enter, this::tell);
        }
    }

    /** Someone goes to the other door; the body breathes on. */
    void close() {
        if (stage != Stage.CLOSED) {
            stage = Stage.CLOSED;
            choose(Choosing.NOTHING);
            leaveRun();
            session.live().setSpeed(session.speed());
            view.mark(Optional::empty);
            looks.dress(style -> style, Optional.empty());
        }
    }

    boolean isOpen() {
        return stage != Stage.CLOSED;
    }

    private void leaveRun() {
        session.live().unwatch();
        work.drop();
        rehearsal = null;
    }

    /** Ends its threads. */
    void end() {
        leaveRun();
        work.close();
        cutter.shutdownNow();
    }

    @Override
    public void onLoading(String what, double howFar) {
        if (isOpen() && stage != Stage.LOADING) {
            stage = Stage.LOADING;
            leaveRun();
            tell();
        }
    }

    @Override
    public void onScene(LiveScene now) {
        if (isOpen()) {
            enter(now);
        }
    }

    /** Another breathing than was looked at is looked at anew. */
    @Override
    public void onChange() {
        if ((stage == Stage.READY || stage == Stage.SHOWING || stage == Stage.MAPPING)
                && !breathing.equals(breathingNow())) {
            look();
        }
    }

    private Map<String, Object> breathingNow() {
        return withoutHold(session.scenario());
    }

    private static Map<String, Object> withoutHold(Scenario scenario) {
        Map<String, Object> map = new LinkedHashMap<>(scenario.toMap());
        map.remove("hold");
        return map;
    }

    private void enter(LiveScene now) {
        stage = Stage.LOADING;
        leaveRun();
        if (scene == null) {
            // The view has taken the scene over by then.
            SwingUtilities.invokeLater(
                    () -> view.setCamera(view.camera().seen(View.ANTERIOR).orbit(FROM_RIGHT_DEG, FROM_ABOVE_DEG)));
        }
        scene = now;
        cycle = List.of();
        study = Optional.empty();
        noEntry();
        looks.dress(style -> style, Optional.empty());
        tell();
        inBackground(
                () -> {
                    ofScene = now.newFrame().get();
                    mapped = new MovingScene(now.surfaces());
                    lived = new MovingScene(now.surfaces());
                    mapped.take(ofScene);
                    return now;
                },
                same -> look());
    }

    private void noEntry() {
        entry = Optional.empty();
        advice = Optional.empty();
    }

    /** Has the run's first breath looked at, as fast as it goes. */
    private void look() {
        leaveRun();
        stage = Stage.LOOKING;
        share = 0;
        breathing = breathingNow();
        if (exercise.isPresent() && !breathing.equals(withoutHold(exercise.get().scenario()))) {
            // Another breathing than the exercise's: its target stays, to practise on.
            exercise = Optional.empty();
        }
        BooleanSupplier current = work.current();
        CycleRecorder recorder = new CycleRecorder(
                session.live(),
                ofScene,
                exercise.map(RehearsalPlan::phases).orElse(BreathCycle.PHASES),
                done -> SwingUtilities.invokeLater(() -> {
                    if (current.getAsBoolean()) {
                        share = done;
                        tell();
                    }
                }),
                whole -> SwingUtilities.invokeLater(() -> {
                    if (current.getAsBoolean()) {
                        cycle = whole;
                        map();
                    }
                }));
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        startRun(recorder, recorder);
        tell();
    }

    /** From the start, breathing, and looked at. */
    private void startRun(Watch.When when, Watch watch) {
        if (session.scenario().hold()) {
            session.live().change(List.of(new Assignment("window", "hold", "false")));
        }
        session.live().restart(when, watch);
        session.live().play();
    }

    /** The map of the exercise's target, of the one at hand, or of one at random. */
    private void map() {
        Optional<RehearsalPlan> asked = exercise;
        Optional<Target> before = study.map(TargetStudy::target);
        double size = targetMm;
        map(() -> asked.isPresent()
                ? asked.get().target(mapped)
                : before.orElseGet(() -> Target.random(mapped, SEED, size)));
    }

    private void map(Callable<Target> where) {
        stage = Stage.MAPPING;
        session.live().setSpeed(session.speed());
        tell();
        Scenario scenario = session.scenario().with("hold=false");
        List<BreathMoment> moments = cycle;
        Optional<RehearsalPlan> asked = exercise;
        List<Surface> surfaces = scene.surfaces();
        inBackground(
                () -> {
                    Target target = where.call();
                    RehearsalPlan meant =
                            asked.orElseGet(() -> RehearsalPlan.practice(scenario, target, Needle.usual()));
                    try (Workers workers =
                            Workers.of(Math.max(1, Runtime.getRuntime().availableProcessors() - 1))) {
                        TargetStudy made =
                                TargetStudy.of(mapped, moments, target, meant.needle(), meant.avoided(), workers);
                        return new Studied(meant, made, new AccessField(surfaces, made.map()));
                    }
                },
                made -> {
                    plan = made.plan();
                    study = Optional.of(made.study());
                    looks.dress(made.colours()::shown, Optional.of(made.colours()));
                    noEntry();
                    begin(Optional.empty());
                });
    }

    private record Studied(RehearsalPlan plan, TargetStudy study, AccessField colours) {}

    /** A new attempt from the start of the run; by hand, or by the steps of the exercise. */
    private void begin(Optional<RehearsalPlan> played) {
        leaveRun();
        TargetStudy about = study.orElseThrow();
        stage = played.isPresent() ? Stage.SHOWING : Stage.READY;
        BooleanSupplier current = work.current();
        rehearsal = new LiveRehearsal(
                session.live(),
                lived,
                ofScene,
                played.orElse(plan),
                about.target(),
                played.map(p -> about.map()),
                new LiveRehearsal.Listener() {
                    @Override
                    public void refused(String sentence) {
                        SwingUtilities.invokeLater(() -> session.say(Session.Message.Kind.REFUSED, sentence));
                    }

                    @Override
                    public void finished(LiveAttempt attempt) {
                        SwingUtilities.invokeLater(() -> {
                            if (current.getAsBoolean()) {
                                report(attempt, played);
                            }
                        });
                    }
                });
        LiveRehearsal watching = rehearsal;
        SectionFeed feed =
                new SectionFeed(cutter, scene.surfaces(), scene.newFrame().get(), (along, across) -> {
                    if (current.getAsBoolean()) {
                        listeners.forEach(l -> l.onSections(along, across));
                    }
                });
        entry.ifPresent(rehearsal::enterAt);
        startRun(Watch.When.every(Rehearsal.LOOK_EVERY_S), (frame, label) -> {
            watching.see(frame, label);
            feed.offer(frame, watching.state());
        });
        session.live().setSpeed(session.speed());
        listeners.forEach(Events::onBegin);
        tell();
    }

    private void report(LiveAttempt attempt, Optional<RehearsalPlan> played) {
        TargetStudy about = study.orElseThrow();
        RehearsalPlan done = played.orElseGet(() -> attempt.planned(plan));
        LiveScene of = scene;
        if (played.isPresent()) {
            stage = Stage.READY;
        }
        MovingScene reader = mapped;
        // An attempt that has ended counts, whatever was begun meanwhile.
        work.keep(
                () -> new Rehearsal(
                        done,
                        of.surfaces(),
                        about,
                        Rehearsal.plannedPath(done, about, reader),
                        attempt.record(),
                        attempt.views(),
                        attempt.stateHash()),
                rehearsed -> {
                    listeners.forEach(l -> l.onAttempt(rehearsed));
                    tell();
                },
                sentence -> session.say(Session.Message.Kind.REFUSED, sentence));
    }

    private <T> void inBackground(Callable<T> what, Consumer<T> then) {
        work.run(what, then, this::refuse);
    }

    private void refuse(String sentence) {
        if (stage == Stage.MAPPING && exercise.isPresent()) {
            exercise = Optional.empty();
            study = Optional.empty();
            map();
        } else if (stage == Stage.LOADING || (stage == Stage.MAPPING && study.isEmpty())) {
            stage = Stage.IMPOSSIBLE;
            doing = sentence;
        } else if (stage == Stage.MAPPING) {
            begin(Optional.empty());
        }
        session.say(Session.Message.Kind.REFUSED, sentence);
        tell();
    }

    private void tell() {
        listeners.forEach(Events::onDoor);
    }

    /** Practises on the body as it is. */
    void practise() {
        if (exercise.isPresent()) {
            exercise = Optional.empty();
            study = Optional.empty();
            noEntry();
            if (stage != Stage.LOADING && !cycle.isEmpty()) {
                leaveRun();
                map();
            }
        }
    }

    /** Opens an exercise: its body breathes as it says, and its target is there. */
    void open(RehearsalPlan other) {
        exercise = Optional.of(other);
        noEntry();
        study = Optional.empty();
        if (scene != null && breathingNow().equals(withoutHold(other.scenario())) && stage != Stage.LOADING) {
            look();
        } else {
            stage = Stage.LOADING;
            leaveRun();
            session.open("Exercise " + other.title(), other.scenario());
            tell();
        }
    }

    /** From the start again, with the same target and entry. */
    void retry() {
        if (study.isPresent() && (stage == Stage.READY || stage == Stage.SHOWING)) {
            begin(Optional.empty());
        }
    }

    /** Plays the exercise as it ships. */
    void demonstrate() {
        if (exercise.isPresent() && study.isPresent() && (stage == Stage.READY || stage == Stage.SHOWING)) {
            noEntry();
            begin(exercise);
        }
    }

    /** The next click chooses; nothing if it is pressed again. */
    void choose(Choosing what) {
        choosing = what == choosing || stage != Stage.READY ? Choosing.NOTHING : what;
        if (choosing == Choosing.TARGET && exercise.isPresent()) {
            choosing = Choosing.NOTHING;
            session.say(
                    Session.Message.Kind.NOTE, "The exercise sets the target; choose Practice for one of your own.");
        }
        view.setCursor(Cursor.getPredefinedCursor(
                choosing == Choosing.NOTHING ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        tell();
    }

    Choosing choosing() {
        return choosing;
    }

    /** What was clicked on while something was being chosen. */
    void chosen(Optional<Pick> pick) {
        Choosing what = choosing;
        choose(Choosing.NOTHING);
        if (pick.isEmpty()) {
            session.say(
                    Session.Message.Kind.NOTE,
                    what == Choosing.ENTRY ? "Click on the skin for the entry." : "Click on the liver for the target.");
        } else if (what == Choosing.ENTRY) {
            enterAt(pick.get().rest());
        } else {
            aimAt(pick.get());
        }
    }

    private void aimAt(Pick pick) {
        double[] rest = pick.rest();
        double[] sight = pick.sight();
        double size = targetMm;
        leaveRun();
        map(() -> Target.behind(mapped, rest, sight, BEHIND_MM, size));
    }

    /** Another size of the target, in the same place. */
    void setTargetMm(double diameterMm) {
        targetMm = diameterMm;
        if (stage == Stage.READY && exercise.isEmpty() && study.isPresent()) {
            double[] at = study.get().target().restMm();
            leaveRun();
            map(() -> Target.at(mapped, at, diameterMm));
        }
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. */
    void enterAt(double[] onSkinRest) {
        if (stage != Stage.READY) {
            return;
        }
        if (state().filter(s -> s.placed() && s.depthMm() > 0).isPresent()) {
            session.say(Session.Message.Kind.NOTE, "Take the needle out first.");
            return;
        }
        entry = Optional.of(onSkinRest);
        hand.enterAt(onSkinRest);
        TargetStudy about = study.orElseThrow();
        inBackground(
                () -> PathCycle.of(
                        mapped, about.map().cycle(), onSkinRest, about.target(), plan.needle(), plan.avoided()),
                found -> {
                    advice = Optional.of(PathAdvice.of(found));
                    tell();
                });
    }

    /** The best entry of the map, over the breath or at its end. */
    void enterAtBest(boolean atEndExpiration) {
        if (stage == Stage.READY) {
            Optional<Integer> best = atEndExpiration
                    ? study.orElseThrow().map().bestAt(0, Rehearsal.ROOM_MM)
                    : study.orElseThrow().map().best(Rehearsal.ROOM_MM);
            if (best.isPresent()) {
                enterAt(study.get().map().pointAtRest(best.get()));
            } else {
                session.say(Session.Message.Kind.NOTE, "From nowhere on the skin is the way to this target free.");
            }
        }
    }

    /** What moves the needle. */
    NeedleHand hand() {
        return hand;
    }

    /** The needle in the run; empty unless it may be used. */
    Optional<LiveRehearsal> usable() {
        return stage == Stage.READY ? Optional.ofNullable(rehearsal) : Optional.empty();
    }

    Optional<double[]> entry() {
        return entry;
    }

    private Optional<NeedleMarks> marks() {
        LiveRehearsal now = rehearsal;
        NeedleState state = now == null ? null : now.state();
        return state == null ? Optional.empty() : Optional.of(new NeedleMarks(state, level(state)));
    }

    /** How the way is marked at this moment. */
    PathAdvice.Level level(NeedleState state) {
        if (!state.reasons().isEmpty()) {
            return PathAdvice.Level.BARRED;
        }
        boolean close = state.marginMm() < Rehearsal.ROOM_MM;
        boolean partly = advice.filter(a -> a.level() != PathAdvice.Level.FREE).isPresent();
        return close || partly || !state.warnings().isEmpty() ? PathAdvice.Level.CAREFUL : PathAdvice.Level.FREE;
    }

    Stage stage() {
        return stage;
    }

    /** What is said of a body on which nothing can be rehearsed. */
    String doing() {
        return doing;
    }

    /** How much of the breath was looked at. */
    double share() {
        return share;
    }

    Optional<RehearsalPlan> exercise() {
        return exercise;
    }

    Optional<TargetStudy> study() {
        return study;
    }

    Optional<PathAdvice> advice() {
        return advice;
    }

    Optional<NeedleState> state() {
        LiveRehearsal now = rehearsal;
        return now == null ? Optional.empty() : Optional.ofNullable(now.state());
    }

    Optional<RehearsalPlan> plan() {
        return Optional.ofNullable(plan);
    }
}
