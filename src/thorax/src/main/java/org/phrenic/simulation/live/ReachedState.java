package org.phrenic.simulation.live;

import org.phrenic.scenario.Scenario;

/**
 * A state of a live run and how to reach it again.
 *
 * @param command command line that reproduces the run so far without a window
 * @param stateHash hash of the state, equal to the {@code state_sha256} that the command prints; empty before the first
 *     scene
 */
public record ReachedState(String command, String stateHash) {
    /** The state of a running scene, or without one a scenario that has not begun. */
    static ReachedState of(RunningScene running, Scenario requested) {
        return running == null
                ? new ReachedState(RunCommandLine.of(requested), "")
                : new ReachedState(RunCommandLine.of(running.recordedScenario()), running.simulation.stateHash());
    }
}
