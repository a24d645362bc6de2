package org.phrenic.access.plan;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.path.AccessBySpace;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/**
 * A plan from beginning to end without a screen: a breath is recorded, the access map worked out, the body breathes
 * anew and the plan is played.
 *
 * @param plan what was played
 * @param surfaces of the body
 * @param targetAccess the target it was about, and from where that can be reached
 * @param path the planned path over the breath; empty where nothing was placed
 * @param record of the attempt
 * @param snapshots what to make pictures of, in order
 * @param stateHash of the body at the end
 */
public record Rehearsal(
        RehearsalPlan plan,
        List<Surface> surfaces,
        TargetAccess targetAccess,
        Optional<PathOverBreath> path,
        AttemptRecord record,
        List<NeedleSnapshot> snapshots,
        String stateHash) {
    /**
     * Between two looks of the needle, s of simulated time. A window that wants the same record gives the session
     * frames at the same times.
     */
    public static final double FRAME_INTERVAL_S = 0.02;

    /** What counts as room enough about a path, mm; see {@link AccessMap#best}. */
    public static final double SUFFICIENT_MARGIN_MM = 3;

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    /**
     * Plays a plan.
     *
     * @throws BadInputException with one sentence, if it cannot be played as it stands
     */
    public static Rehearsal play(RehearsalPlan plan, SimulationRun.Progress progress) {
        Thorax thorax = SimulationRun.loadThorax(plan.scenario());
        thorax.notes().forEach(progress::note);
        return play(plan, thorax, progress);
    }

    /** As {@link #play(RehearsalPlan, SimulationRun.Progress)}, on the plan's body that is at hand already. */
    public static Rehearsal play(RehearsalPlan plan, Thorax thorax, SimulationRun.Progress progress) {
        try (Simulation simulation = Simulation.of(plan.scenario(), thorax);
                Workers workers = Workers.of(plan.scenario().threads())) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            Frame frame = surfaces.newFrame();
            MovingAnatomy scene = new MovingAnatomy(surfaces.surfaces());
            scene.update(frame);
            TargetLesion target = plan.target(scene);
            requireEntries(plan, scene, target);
            List<BreathMoment> cycle = BreathCycle.record(simulation, surfaces, plan.moments());
            long begun = System.nanoTime();
            AccessMap map = AccessMap.of(scene, cycle, target, plan.needle(), plan.avoided(), workers);
            progress.note(String.format(
                    Locale.ROOT,
                    "Access map: %d points of the skin, %s of them in reach, at %d moments in %.2f s.",
                    map.size(),
                    map.counts().get("in_reach"),
                    cycle.size(),
                    1e-9 * (System.nanoTime() - begun)));
            TargetAccess study = new TargetAccess(target, map, AccessBySpace.of(scene, map, plan.needle()));
            Optional<PathOverBreath> path = plannedPath(plan, study, scene);
            if (simulation.restart()) {
                return attempt(plan, simulation, surfaces, frame, scene, study, path, progress);
            }
        }
        throw new BadInputException(
                plan.file()
                        + ": found a scenario with changes of its own, expected one without: a plan holds the breath by its steps");
    }

    private static Rehearsal attempt(
            RehearsalPlan plan,
            Simulation simulation,
            SceneSurfaces surfaces,
            Frame frame,
            MovingAnatomy scene,
            TargetAccess study,
            Optional<PathOverBreath> path,
            SimulationRun.Progress progress) {
        NeedleInsertion needle = new NeedleInsertion(scene, study.target(), plan.needle(), plan.avoided());
        PlanPlayer player = new PlanPlayer(
                plan,
                needle,
                study.map(),
                (held, origin) -> simulation.change(Assignment.of(origin, Breathing.HOLD, held)));
        NeedleSnapshots views = new NeedleSnapshots();
        boolean done = false;
        long begun = System.nanoTime();
        while (!done) {
            surfaces.capture(frame);
            RespiratoryPhase label = simulation.breathLabel();
            needle.update(frame, label);
            done = player.update(label, 1 + (int) frame.values()[BREATH]);
            views.observe(needle, frame, label);
            step(simulation, done);
            double perS = simulation.steps() / (1e-9 * (System.nanoTime() - begun));
            progress.advanced(simulation.time(), Math.max(simulation.time(), simulation.durationS()), perS);
        }
        return new Rehearsal(
                plan, surfaces.surfaces(), study, path, needle.record(), views.all(), simulation.stateHash());
    }

    private static void step(Simulation simulation, boolean done) {
        long steps = done
                ? 0
                : Math.max(1, Math.round(FRAME_INTERVAL_S / simulation.stepper().dt()));
        for (long i = 0; i < steps; i++) {
            simulation.step();
        }
    }

    /** Finds an entry that is not on the skin, or too far from the target, before a breath is simulated. */
    private static void requireEntries(RehearsalPlan plan, MovingAnatomy scene, TargetLesion target) {
        for (PlanStep step : plan.steps()) {
            if (step instanceof PlanStep.Place place && place.entryRest().isPresent()) {
                try {
                    SkinPoint.atRest(scene.skin(), place.entryRest().get());
                    plan.needle()
                            .requireReach(
                                    place.entryRest().get(), place.aim().point().orElse(target.restMm()));
                } catch (BadInputException bad) {
                    throw new BadInputException(step.place() + ": " + bad.getMessage(), bad);
                }
            }
        }
    }

    /**
     * The path from where a plan enters first, over the breath; empty where nothing is placed. Afterwards the scene
     * shows the last moment of the breath.
     */
    public static Optional<PathOverBreath> plannedPath(RehearsalPlan plan, TargetAccess study, MovingAnatomy scene) {
        return plan.steps().stream()
                .filter(PlanStep.Place.class::isInstance)
                .map(step -> PlanPlayer.entry((PlanStep.Place) step, study.map()))
                .findFirst()
                .map(entry -> PathOverBreath.of(
                        scene, study.map().cycle(), entry, study.target(), plan.needle(), plan.avoided()));
    }

    /** The target it was about. */
    public TargetLesion target() {
        return targetAccess.target();
    }

    /** From where the target can be reached. */
    public AccessMap map() {
        return targetAccess.map();
    }

    /** Whether what counts as done was reached; true where the plan asks for nothing. */
    public boolean goalsReached() {
        return plan.goals().reached(record);
    }
}
