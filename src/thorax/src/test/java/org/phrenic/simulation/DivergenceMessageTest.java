package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

class DivergenceMessageTest {
    private static final Scenario LOW =
            Scenario.defaults().with("resolution=low").with("lungs=off");

    /** A speed beyond all bounds is put in at the first node, which belongs to the diaphragm. */
    @Test
    void divergenceNamesStructureAndPlace() {
        try (Simulation simulation = Simulation.of(LOW, SimulationRun.loadThorax(LOW))) {
            int free = simulation.scene().diaphragm().freeVertices()[0];
            simulation.step();
            int inside = simulation.system().layout().internal(free);
            simulation.system().velocities()[3 * inside] = 1e9;
            assertThatThrownBy(simulation::step)
                    .isInstanceOf(DivergenceException.class)
                    .hasMessageContaining("diverged at 0.0025 s (")
                    .hasMessageMatching(".*node \\d+ of the diaphragm \\(x -?\\d+, y -?\\d+, z -?\\d+ mm at rest\\).*");
        }
    }

    @Test
    void bodyThatCannotBreatheIsRefused() {
        Thorax whole = SimulationRun.loadThorax(LOW);
        for (StructureKind lacking : List.of(StructureKind.DIAPHRAGM, StructureKind.RIB)) {
            Thorax body = new Thorax(
                    "patient",
                    whole.structures().stream().filter(s -> s.kind() != lacking).toList(),
                    List.of());
            assertThatThrownBy(() -> Simulation.of(LOW, body))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageStartingWith("patient: this body cannot breathe, found no "
                            + (lacking == StructureKind.RIB ? "ribs" : "diaphragm"));
        }
        assertThat(whole.structuresOf(StructureKind.RIB)).isNotEmpty();
    }
}
