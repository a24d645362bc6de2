package org.phrenic.study;

import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.scenario.Scenario;

/** Scenarios that reproduce the paper's results, on the virtual adult male. */
public final class PaperScenarios {
    /** The paper's time step, s. */
    public static final double STEP_S = 0.01;

    private PaperScenarios() {}

    /** The program's default model: membrane, pressure, muscle that shortens. */
    public static Scenario defaultModel(String preset, Resolution resolution) {
        return Scenario.defaults().with("preset=" + preset, resolution(resolution));
    }

    /** The paper's model: its springs, masses, action lines, and tendon above a plane. */
    public static Scenario publishedModel(String preset, Resolution resolution) {
        return defaultModel(preset, resolution).with("material=paper", "pressure=false", "tendon=plane");
    }

    private static String resolution(Resolution resolution) {
        return "resolution=" + resolution.name().toLowerCase(Locale.ROOT);
    }
}
