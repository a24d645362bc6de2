package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.file.Numbers.trimmed;

import java.util.List;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * Time integration settings that determine cost and error of a run on a given mesh.
 *
 * @param integrator scheme
 * @param timeStepS time step, s
 * @param sweeps constraint sweeps per step
 * @param refreshS refresh interval of anchors and wall planes, s
 */
public record SolverSettings(IntegratorKind integrator, double timeStepS, int sweeps, double refreshS) {

    /** The settings of a scenario. */
    public static SolverSettings of(Scenario scenario) {
        return new SolverSettings(
                scenario.integrator(),
                scenario.timeStepS(),
                scenario.get(Numerics.PROJECTION_SWEEPS),
                scenario.get(Numerics.REFRESH));
    }

    /** The settings as scenario assignments. */
    public List<Assignment> assignments(String origin) {
        return List.of(
                Assignment.of(origin, Numerics.INTEGRATOR, integrator),
                Assignment.of(origin, Numerics.TIME_STEP, timeStepS),
                Assignment.of(origin, Numerics.PROJECTION_SWEEPS, sweeps),
                Assignment.of(origin, Numerics.REFRESH, refreshS));
    }

    /** Readable description for progress messages and reports. */
    public String label() {
        return format(
                "%s, step %s s, %d sweep%s, refresh %s s",
                integrator.label(), number(timeStepS), sweeps, sweeps == 1 ? "" : "s", number(refreshS));
    }

    /** Formats a time with at most four significant digits. */
    static String number(double seconds) {
        return trimmed(seconds, 4);
    }
}
