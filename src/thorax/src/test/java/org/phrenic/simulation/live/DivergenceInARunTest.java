package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;

/** What is told of divergences that follow one another. */
class DivergenceInARunTest extends LiveRunEvents {
    /** The state that comes back is one that no change has saved: the run notes that it goes on from there. */
    @Test
    void theChangeThatIsToldAndUndoneIsOneThatWasMade() throws InterruptedException {
        Scenario start = Runs.scenario(Runs.sheetAlone("mesh_vertices=3000"));
        SimulationLoop loop = new SimulationLoop(new RequestedSettings(start), this);
        Simulation simulation = Runs.simulation(start);
        try (RunningScene scene = new RunningScene(
                simulation, new SceneSurfaces(simulation), simulation.scene().thorax(), 1, false)) {
            loop.take(scene);
            simulation.change(Assignment.parse("depth=0.9"));
            for (int i = 0; i < 3000; i++) {
                simulation.step();
            }
            for (int i = 0; i < 2; i++) {
                simulation.system().velocities()[0] = Double.NaN;
                loop.advance(scene, 1, Long.MAX_VALUE);
                assertThat(next(divergences)).endsWith("the last change was depth");
                assertThat(simulation.steps()).isPositive();
                loop.advance(scene, 1, Long.MAX_VALUE);
            }
            simulation.system().velocities()[0] = Double.NaN;
            loop.advance(scene, 1, Long.MAX_VALUE);
            loop.restoreLastGood();
            assertThat(next(undone)).isEqualTo(Set.of("depth"));
        }
    }
}
