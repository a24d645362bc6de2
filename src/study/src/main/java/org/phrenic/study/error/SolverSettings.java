package org.phrenic.study.error;

import java.util.List;
import java.util.Locale;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * How a scene is carried through time: what decides speed and error of a run whose meshes are given.
 *
 * @param integrator scheme
 * @param timeStepS step of the clock, s
 * @param sweeps over all constraints a step
 * @param refreshS simulated time after which anchors and wall planes are taken anew, s
 */
public record SolverSettings(IntegratorKind integrator, double timeStepS, int sweeps, double refreshS) {

    /** Those of a scenario. */
    public static SolverSettings of(Scenario scenario) {
        return new SolverSettings(
                scenario.integrator(), scenario.timeStepS(), scenario.projectionSweeps(), scenario.refreshS());
    }

    /** As keys of a scenario. */
    public List<Assignment> assignments(String origin) {
        return List.of(
                new Assignment(origin, "integrator", integrator.label()),
                new Assignment(origin, "time_step_s", Double.toString(timeStepS)),
                new Assignment(origin, "projection_sweeps", Integer.toString(sweeps)),
                new Assignment(origin, "refresh_s", Double.toString(refreshS)));
    }

    /** In words, for progress and sentences. */
    public String label() {
        return String.format(
                Locale.ROOT,
                "%s, step %s s, %d sweep%s, refresh %s s",
                integrator.label(),
                number(timeStepS),
                sweeps,
                sweeps == 1 ? "" : "s",
                number(refreshS));
    }

    /** A time for people, without digits that say nothing. */
    static String number(double seconds) {
        return String.format(Locale.ROOT, "%.4g", seconds)
                .replaceFirst("(\\.\\d*?)0+$", "$1")
                .replaceFirst("\\.$", "");
    }
}
