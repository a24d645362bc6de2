package org.phrenic.study;

import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.Scenario;

/** Scenarios that reproduce the paper's results, on the virtual adult male. */
public final class PaperScenarios {
    /** The paper's time step, s. */
    public static final double STEP_S = 0.01;

    /** Setting of the mesh of a quick reproduction, a quarter of that at low resolution. */
    public static final String QUICK_MESH = "mesh_vertices=3000";

    private PaperScenarios() {}

    /** The program's default model: membrane, pressure, muscle that shortens. */
    public static Scenario defaultModel(String preset, Resolution resolution) {
        return Scenario.defaults().with("preset=" + preset, resolution(resolution));
    }

    /** The paper's model: its springs, masses, action lines, tendon above a plane, and midpoint Runge-Kutta. */
    public static Scenario publishedModel(String preset, Resolution resolution) {
        return defaultModel(preset, resolution).with("material=published");
    }

    /** Integrator and time step of a scenario, as in {@code rk2, 10 ms}. */
    public static String scheme(Scenario scenario) {
        return scenario.integrator().label() + ", " + Numbers.trimmed(1000 * scenario.timeStepS(), 4) + " ms";
    }

    private static String resolution(Resolution resolution) {
        return "resolution=" + resolution.name().toLowerCase(Locale.ROOT);
    }
}
