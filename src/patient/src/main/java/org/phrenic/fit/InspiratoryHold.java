package org.phrenic.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Observation;

/**
 * Simulates the second breath level: a fast inspiration followed by a breath hold. Parameter values are applied at the
 * first step, so the body is assembled only once for all evaluations. Each evaluation starts at rest, so the state
 * depends only on the parameter values. The scenario returned by {@link #scenario} reaches a bit-identical state.
 *
 * <p>Not thread-safe.
 */
public final class InspiratoryHold implements AutoCloseable {
    /** Time from rest to end-inspiration, s. */
    public static final double INSPIRATION_S = 0.8;
    /**
     * The search compares a breath after this share of the time until it is near rest. The mean distance then changes
     * by up to 2 % (physical material).
     */
    private static final double SEARCHED_SHARE = 1.0 / 3;

    private static final double INSPIRATORY_FRACTION = 0.5;
    /**
     * Time from the start of a hold to end-inspiration, s. The breath clock stops over 0.2 s and advances by half of
     * that time.
     */
    private static final double STOPPING_S = 0.1;

    private static final Set<String> PRESETS = Set.of("deep", "quiet", "quiet-supine");

    private final Scenario held;
    private final List<FitParameter> parameters;
    private final Simulation simulation;
    private final SceneSurfaces surfaces;

    /**
     * Assembles the body and lets it settle.
     *
     * @param base scenario with body, resolution and all settings that are not fitted
     */
    public InspiratoryHold(Scenario base, Thorax thorax, List<FitParameter> parameters) {
        held = held(base);
        this.parameters = List.copyOf(parameters);
        simulation = Simulation.of(held, thorax);
        surfaces = new SceneSurfaces(simulation);
    }

    private static Scenario held(Scenario base) {
        if (!PRESETS.contains(base.preset()) || base.trace().isPresent()) {
            throw new BadInputException(
                    "fit: found " + (base.trace().isPresent() ? "a trace" : "preset '" + base.preset() + "'")
                            + ", expected preset deep, quiet or quiet-supine");
        }
        return base.withChanges(List.of())
                .with(Breathing.RATE, 60 * INSPIRATORY_FRACTION / INSPIRATION_S)
                .with(Breathing.INSPIRATORY_FRACTION, INSPIRATORY_FRACTION)
                .with(RunSettings.DURATION, observedAtS(base));
    }

    /** Time from rest to the observation, s. */
    public static double observedAtS(Scenario base) {
        return afterInspiration(base.get(Materials.MATERIAL).heldRestS());
    }

    /** Time from rest to the comparison of a breath of the search, s. */
    public static double searchedAtS(Scenario base) {
        return afterInspiration(SEARCHED_SHARE * base.get(Materials.MATERIAL).heldRestS());
    }

    /** Rounded to whole milliseconds, so that the decimal in a scenario file is short. */
    private static double afterInspiration(double heldS) {
        return Math.round(1000 * (INSPIRATION_S + heldS)) / 1000.0;
    }

    /** The scenario with which {@code phrenic run} reaches the same state. Each value is limited to its bounds. */
    public static Scenario scenario(Scenario base, List<FitParameter> parameters, double[] values) {
        Scenario held = held(base);
        return held.withChanges(changes(held, parameters, values));
    }

    private static List<ScheduledChange> changes(Scenario held, List<FitParameter> parameters, double[] values) {
        List<ScheduledChange> changes = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            changes.add(new ScheduledChange(
                    0, Assignment.of("fit", parameters.get(i).parameter(), values[i])));
        }
        long stop = Math.round((INSPIRATION_S - STOPPING_S) / held.timeStepS());
        changes.add(new ScheduledChange(stop, Assignment.of("fit", Breathing.HOLD, true)));
        return changes;
    }

    /**
     * Simulates the breath from rest to the observation.
     *
     * @return why the simulation failed, in which case the state is undefined; empty if it did not
     */
    public String breatheIn(double[] values) {
        return breatheIn(values, observedAtS(held));
    }

    /** Simulates the breath from rest to the comparison of the search; otherwise as {@link #breatheIn(double[])}. */
    String breatheInForSearch(double[] values) {
        return breatheIn(values, searchedAtS(held));
    }

    private String breatheIn(double[] values, double untilS) {
        try {
            simulation.rerun(changes(held, parameters, values));
            long steps = SimulationRun.stepsFor(untilS, held.timeStepS());
            while (simulation.steps() < steps) {
                simulation.step();
            }
            return "";
        } catch (DivergenceException | IllegalArgumentException | BadInputException unstable) {
            // No substep makes the time step stable, or the breath is impossible.
            return String.valueOf(unstable.getMessage()).replaceAll("[\",\\s]+", " ");
        }
    }

    /** Surfaces of the body, in a fixed order. */
    public SceneSurfaces surfaces() {
        return surfaces;
    }

    /** Mesh of a surface in the current state. */
    public TriangleMesh mesh(int surface) {
        return surfaces.mesh(surface);
    }

    /** Value of an observable in the current state, such as {@code dome_right_mm}. */
    public double observed(String column) {
        return surfaces.observe()[Observation.COLUMNS.indexOf(column)];
    }

    /** Hash of the exact bits of the state. */
    public String stateHash() {
        return simulation.stateHash();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
