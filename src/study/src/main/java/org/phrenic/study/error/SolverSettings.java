package org.phrenic.study.error;

import java.util.List;
import java.util.Locale;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;

/**
 * How a scene is integrated in time: what decides speed and error of a run on given meshes.
 *
 * @param integrator scheme
 * @param timeStepS step of the clock, s
 * @param sweeps over all constraints a step
 * @param refreshS interval at which anchors and wall planes are refreshed, s
 */
public record SolverSettings(IntegratorKind integrator, double timeStepS, int sweeps, double refreshS) {

    /** Those of a scenario. */
    public static SolverSettings of(Scenario scenario) {
        return new SolverSettings(
                scenario.integrator(),
                scenario.timeStepS(),
                scenario.get(Numerics.PROJECTION_SWEEPS),
                scenario.get(Numerics.REFRESH));
    }

    /** As keys of a scenario. */
    public List<Assignment> assignments(String origin) {
        return List.of(
                Assignment.of(origin, Numerics.INTEGRATOR, integrator),
                Assignment.of(origin, Numerics.TIME_STEP, timeStepS),
                Assignment.of(origin, Numerics.PROJECTION_SWEEPS, sweeps),
                Assignment.of(origin, Numerics.REFRESH, refreshS));
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

    /** A time with at most four significant digits. */
    static String number(double seconds) {
        return ReportNumbers.trimmed(seconds, 4);
    }
}
