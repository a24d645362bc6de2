package org.phrenic.scene;

import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SimulationRun;

/** The two ends of a scenario's first breath: where both domes together stand lowest, and where the breath is over. */
final class BreathEnds implements AutoCloseable {
    private static final double LOOK_EVERY_S = 0.05;
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int RIGHT = Observation.COLUMNS.indexOf("dome_right_mm");
    private static final int LEFT = Observation.COLUMNS.indexOf("dome_left_mm");

    private final ScenePlayer player;
    private final Frame rest;
    private final Frame inspired;
    private final Frame expired;

    /** Breathes one breath. */
    BreathEnds(Scenario scenario, SimulationRun.Progress progress) {
        player = new ScenePlayer(scenario, progress);
        rest = player.at(0).copy();
        inspired = rest.copy();
        Frame now = player.at(0);
        for (int look = 1; now.values()[BREATH] == rest.values()[BREATH] && now.timeS() < player.totalS(); look++) {
            now = player.at(look * LOOK_EVERY_S);
            if (domes(now) < domes(inspired)) {
                inspired.copyFrom(now);
            }
        }
        expired = now.copy();
    }

    private static double domes(Frame frame) {
        return frame.values()[RIGHT] + frame.values()[LEFT];
    }

    ScenePlayer player() {
        return player;
    }

    /** As it was before the breath. */
    Frame rest() {
        return rest;
    }

    Frame inspired() {
        return inspired;
    }

    Frame expired() {
        return expired;
    }

    @Override
    public void close() {
        player.close();
    }
}
