package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

class MeshVerticesTest {
    @Test
    void theStatedNumberOfVerticesReplacesThatOfTheResolution() {
        Scenario scenario = Scenario.defaults().with("mesh_vertices=3000", "resolution=high");
        assertThat(OrganSettings.budget(scenario)).isEqualTo(new MeshBudget(3000));
        assertThat(OrganSettings.meshLabel(scenario)).isEqualTo("3,000 vertices");
        Thorax thorax = SimulationRun.loadThorax(scenario);
        int sheet = thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh().vertexCount();
        assertThat(sheet).isBetween(1600, 1660);
    }

    @Test
    void withoutItTheResolutionDecidesAndTheScenarioDoesNotListIt() {
        Scenario scenario = Scenario.defaults().with("resolution=high");
        assertThat(OrganSettings.budget(scenario)).isEqualTo(Resolution.HIGH.budget());
        assertThat(OrganSettings.meshLabel(scenario)).isEqualTo("high");
        assertThat(scenario.toMap()).doesNotContainKey("mesh_vertices");
        assertThat(scenario.with("mesh_vertices=5000").toMap()).containsEntry("mesh_vertices", 5000L);
    }

    @Test
    void aBudgetForADiaphragmGivesItThatManyVertices() {
        assertThat(MeshBudget.ofDiaphragm(19_586).diaphragmVertices()).isEqualTo(19_586);
        assertThat(Resolution.MEDIUM.diaphragmVertices()).isEqualTo(8705);
    }

    @Test
    void tooFewVerticesAreRefused() {
        assertThatThrownBy(() -> Scenario.defaults().with("mesh_vertices=20"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 20, expected 1000 to 1000000");
    }
}
