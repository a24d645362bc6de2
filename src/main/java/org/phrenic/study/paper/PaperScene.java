package org.phrenic.study.paper;

import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.simulation.Scenario;

/** The scenarios that are simulated for the paper's results, on the virtual adult male. */
public final class PaperScene {
    /** The paper's time step, s. */
    static final double STEP_S = 0.01;

    private PaperScene() {}

    /** The model as it is used here: membrane, pressure, muscle that shortens. */
    public static Scenario own(String preset, Resolution resolution) {
        return Scenario.defaults().with("preset=" + preset, resolution(resolution));
    }

    /** The model with the paper's springs, masses, action lines and tendon above a plane. */
    public static Scenario asPublished(String preset, Resolution resolution) {
        return own(preset, resolution).with("material=paper", "pressure=false", "tendon=plane");
    }

    private static String resolution(Resolution resolution) {
        return "resolution=" + resolution.name().toLowerCase(Locale.ROOT);
    }
}
