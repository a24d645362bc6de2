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
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Observation;

/**
 * The second breath level: a breath taken in quickly and held, with the numbers of a fit as changes at the first step,
 * so that the body is assembled once for all of them and its shape at rest stays. Always from rest: what is reached is
 * a function of the numbers alone, and the scenario that {@link #scenario} gives reaches it too, bit by bit.
 *
 * <p>Used by one thread.
 */
public final class InspiratoryHold implements AutoCloseable {
    /** Time from rest to end-inspiration, s. */
    public static final double INSPIRATION_S = 0.8;
    /** Time from rest to where the state is looked at, s; docs/fit.md says how far it is from equilibrium then. */
    public static final double OBSERVED_AT_S = 1.7;

    private static final double INSPIRATORY_FRACTION = 0.5;
    /** The breath's clock stops over 0.2 s and shows half of that time meanwhile. */
    private static final double STOPPING_S = 0.1;

    private static final Set<String> PRESETS = Set.of("deep", "quiet", "quiet-supine");

    private final Scenario held;
    private final List<FitParameter> parameters;
    private final Simulation simulation;
    private final SceneSurfaces surfaces;

    /**
     * Assembles the body and lets it settle.
     *
     * @param base body, resolution and what else is not tuned
     * @param parameters what is tuned
     */
    public InspiratoryHold(Scenario base, Thorax thorax, List<FitParameter> parameters) {
        held = held(base);
        this.parameters = List.copyOf(parameters);
        simulation = Simulation.of(held, thorax);
        surfaces = new SceneSurfaces(simulation);
    }

    /** A scenario whose breath is taken in quickly, for as long as it takes to hold it. */
    private static Scenario held(Scenario base) {
        if (!PRESETS.contains(base.preset()) || base.trace().isPresent()) {
            throw new BadInputException(
                    "fit: found " + (base.trace().isPresent() ? "a trace" : "preset '" + base.preset() + "'")
                            + ", expected preset deep, quiet or quiet-supine");
        }
        return base.withChanges(List.of())
                .with(Breathing.RATE, 60 * INSPIRATORY_FRACTION / INSPIRATION_S)
                .with(Breathing.INSPIRATORY_FRACTION, INSPIRATORY_FRACTION)
                .with(RunSettings.DURATION, OBSERVED_AT_S);
    }

    /** The scenario that {@code phrenic run} takes to the same state with these values, each within its bounds. */
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
     * Breathes in and holds.
     *
     * @param values of the parameters
     * @return whether the body bore it; if not, it stands somewhere
     */
    public boolean breatheIn(double[] values) {
        try {
            simulation.rerun(changes(held, parameters, values));
            long steps = Math.round(OBSERVED_AT_S / held.timeStepS());
            while (simulation.steps() < steps) {
                simulation.step();
            }
            return true;
        } catch (DivergenceException | IllegalArgumentException unbearable) {
            // A step that no split makes stable is refused as an illegal argument.
            return false;
        }
    }

    /** Goes on holding for so long, s: to see how far the state was from equilibrium. */
    public void holdFor(double seconds) {
        long steps = simulation.steps() + Math.round(seconds / held.timeStepS());
        while (simulation.steps() < steps) {
            simulation.step();
        }
    }

    /** The surfaces, in an order that never changes. */
    public SceneSurfaces surfaces() {
        return surfaces;
    }

    /** Where a surface is now. */
    public TriangleMesh mesh(int surface) {
        return surfaces.mesh(surface);
    }

    /** How far a column of the observables says, such as {@code dome_right_mm}. */
    public double observed(String column) {
        return surfaces.observe()[Observation.COLUMNS.indexOf(column)];
    }

    /** Into how many parts a step was split at the end. */
    public int substeps() {
        return simulation.stepper().substeps();
    }

    /** Hash over the bits of the state. */
    public String stateHash() {
        return simulation.stateHash();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
