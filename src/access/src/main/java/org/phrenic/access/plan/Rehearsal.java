package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.SkinEntries;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.UserCache;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * The result of playing a plan. A breath is recorded, the access map is computed, the simulation is restarted, and the
 * plan is played.
 *
 * @param path path over the breath from the entry of the {@linkplain AttemptRecord#decisive decisive} sample, or
 *     without one from the last entry; empty if the plan places no needle
 * @param probe how the ultrasound probe was used
 * @param snapshots snapshots for pictures, in chronological order
 * @param stateHash hash of the body state at the end
 */
public record Rehearsal(
        RehearsalPlan plan,
        BodySurfaces body,
        TargetAccess targetAccess,
        Optional<PathOverBreath> path,
        AttemptRecord record,
        ProbeUse probe,
        List<NeedleSnapshot> snapshots,
        String stateHash) {
    /** Simulated time between two frames of the needle, s. Live runs use the same frame times. */
    public static final double FRAME_INTERVAL_S = 0.02;

    /**
     * Plays a plan without a window.
     *
     * @throws BadInputException if the plan cannot be played
     */
    public static Rehearsal play(RehearsalPlan plan, SimulationRun.Progress progress) {
        Thorax thorax = SimulationRun.loadThorax(plan.scenario());
        thorax.notes().forEach(progress::note);
        return play(plan, thorax, progress);
    }

    /** Like {@link #play(RehearsalPlan, SimulationRun.Progress)}, with the body of the plan already loaded. */
    public static Rehearsal play(RehearsalPlan plan, Thorax thorax, SimulationRun.Progress progress) {
        try (Simulation simulation = Simulation.of(plan.scenario(), thorax, UserCache.ofUser(), progress);
                Workers workers = Workers.of(plan.scenario().threads())) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            MovingAnatomy anatomy = new MovingAnatomy(surfaces.surfaces());
            anatomy.update(surfaces.newFrame());
            TargetLesion target = plan.target(anatomy);
            requireEntries(plan, anatomy, target);
            List<BreathMoment> cycle = BreathCycle.record(simulation, surfaces, plan.moments());
            long begun = System.nanoTime();
            TargetAccess access = TargetAccess.of(anatomy, cycle, target, plan.needle(), plan.avoided(), workers);
            int reached = access.map().counts().inReach();
            double tookS = 1e-9 * (System.nanoTime() - begun);
            progress.note(Numbers.format(
                    "Access map: %d points of the skin, %s of them in reach, at %d moments in %.2f s%s.",
                    access.map().size(), reached, cycle.size(), tookS, RehearsalReport.limits(cycle)));
            placesOf(plan.steps()).forEach(place -> PlanPlayer.entry(place, access.map()));
            if (simulation.restart()) {
                NeedleSnapshots snapshots = new NeedleSnapshots();
                NeedleInsertion needle = new NeedleInsertion(anatomy, access.target(), plan.needle(), plan.avoided());
                HeldProbe probe = new HeldProbe(anatomy);
                attempt(
                        new PlanPlayer(
                                plan,
                                needle,
                                snapshots,
                                probe,
                                access.map(),
                                (held, origin) -> simulation.change(Assignment.of(origin, Breathing.HOLD, held))),
                        simulation,
                        surfaces,
                        progress);
                AttemptRecord record = needle.record();
                return new Rehearsal(
                        plan,
                        new BodySurfaces(surfaces.surfaces(), thorax),
                        access,
                        plannedPath(plan, access, anatomy, record),
                        record,
                        probe.use(),
                        snapshots.all(),
                        simulation.stateHash());
            }
        }
        throw new BadInputException(plan.file() + ": found a scenario with changes of its own, expected one without:"
                + " a plan holds the breath by its steps");
    }

    private static void attempt(
            PlanPlayer player, Simulation simulation, SceneSurfaces surfaces, SimulationRun.Progress progress) {
        Frame frame = surfaces.newFrame();
        double dt = simulation.stepper().dt();
        long stepsPerFrame = Math.max(1, Math.round(FRAME_INTERVAL_S / dt));
        boolean done = false;
        long begun = System.nanoTime();
        while (!done) {
            surfaces.capture(frame);
            done = player.update(frame, simulation.breathLabel());
            for (long i = 0; !done && i < stepsPerFrame; i++) {
                simulation.step();
            }
            double perS = simulation.steps() / (1e-9 * (System.nanoTime() - begun));
            progress.advanced(simulation.time(), Math.max(simulation.time(), simulation.durationS()), perS);
        }
    }

    /**
     * Checks, before a breath is simulated, that entry points lie on the skin and within reach of an aim that stands
     * still, from the point of the skin at which the needle is placed. The reach to a moving target is checked when the
     * needle is placed. A needle at given angles needs no reach.
     *
     * @param anatomy of a body at the start of the simulation
     */
    static void requireEntries(RehearsalPlan plan, MovingAnatomy anatomy, TargetLesion target) {
        RehearsalImage.requirePlaces(plan.steps(), anatomy);
        for (PlanStep step : plan.steps()) {
            if (step instanceof PlanStep.Place place && place.entryRest().isPresent()) {
                try {
                    double[] entry = SkinEntries.pointAtRest(
                                    anatomy, place.entryRest().get())
                            .current();
                    if (place.aim().standsStill()) {
                        plan.needle().requireReach(entry, place.aim().point().orElse(target.restMm()));
                    }
                } catch (BadInputException bad) {
                    throw new BadInputException(step.place() + ": " + bad.getMessage(), bad);
                }
            }
        }
    }

    /**
     * The path over the breath from the entry of the decisive sample, or without one from the last entry; empty if the
     * plan places no needle. Afterwards the anatomy is at the last moment of the breath.
     */
    public static Optional<PathOverBreath> plannedPath(
            RehearsalPlan plan, TargetAccess access, MovingAnatomy anatomy, AttemptRecord record) {
        return decisivePlace(plan.steps(), record)
                .map(place -> PlanPlayer.entry(place, access.map()))
                .map(entry -> PathOverBreath.of(
                        anatomy, access.map().cycle(), entry, access.target(), plan.needle(), plan.avoided()));
    }

    private static Stream<PlanStep.Place> placesOf(List<PlanStep> steps) {
        return steps.stream().filter(PlanStep.Place.class::isInstance).map(PlanStep.Place.class::cast);
    }

    /** Each sample step has taken a sample of the record, in the same order. */
    private static Optional<PlanStep.Place> decisivePlace(List<PlanStep> steps, AttemptRecord record) {
        int decisive = record.decisive().map(record.samples()::indexOf).orElse(Integer.MAX_VALUE);
        Optional<PlanStep.Place> place = Optional.empty();
        int samples = 0;
        for (PlanStep step : steps) {
            if (step instanceof PlanStep.Place placed) {
                place = Optional.of(placed);
            } else if (step instanceof PlanStep.Sample && samples++ == decisive) {
                return place;
            }
        }
        return place;
    }

    public List<Surface> surfaces() {
        return body.surfaces();
    }

    public TargetLesion target() {
        return targetAccess.target();
    }

    public AccessMap map() {
        return targetAccess.map();
    }

    /** Moments of which the needle is drawn in the body. */
    public List<NeedleSnapshot> needleViews() {
        return snapshots.stream().filter(s -> !s.isForUltrasound()).toList();
    }

    public boolean goalsReached() {
        return plan.goals().reached(record);
    }
}
