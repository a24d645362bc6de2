package org.phrenic.scene;

import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/** The two ends of a scenario's first breath: where both domes together stand lowest, and where the breath is over. */
final class BreathExtremes implements AutoCloseable {
    private static final double SAMPLE_INTERVAL_S = 0.05;
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int RIGHT = Observation.COLUMNS.indexOf("dome_right_mm");
    private static final int LEFT = Observation.COLUMNS.indexOf("dome_left_mm");

    private final ScenePlayer player;
    private final Frame rest;
    private final Frame endInspiration;
    private final Frame endExpiration;

    /** Breathes one breath. */
    BreathExtremes(Scenario scenario, SimulationRun.Progress progress) {
        player = new ScenePlayer(scenario, progress);
        rest = player.advanceTo(0).copy();
        endInspiration = rest.copy();
        Frame now = player.advanceTo(0);
        for (int look = 1; now.values()[BREATH] == rest.values()[BREATH] && now.timeS() < player.durationS(); look++) {
            now = player.advanceTo(look * SAMPLE_INTERVAL_S);
            if (domeHeightSum(now) < domeHeightSum(endInspiration)) {
                endInspiration.copyFrom(now);
            }
        }
        endExpiration = now.copy();
    }

    private static double domeHeightSum(Frame frame) {
        return frame.values()[RIGHT] + frame.values()[LEFT];
    }

    ScenePlayer player() {
        return player;
    }

    /** As it was before the breath. */
    Frame rest() {
        return rest;
    }

    Frame endInspiration() {
        return endInspiration;
    }

    Frame endExpiration() {
        return endExpiration;
    }

    @Override
    public void close() {
        player.close();
    }
}
