package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

class MeshVerticesTest {
    @Test
    void theStatedNumberOfVerticesReplacesThatOfTheResolution() {
        Scenario scenario = Scenario.defaults().with("mesh_vertices=3000", "resolution=high");
        assertThat(OrganSettings.budget(scenario)).isEqualTo(new MeshBudget(3000));
        Thorax thorax = SimulationRun.loadThorax(scenario);
        int sheet = thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh().vertexCount();
        assertThat(sheet).isBetween(1600, 1660);
    }

    @Test
    void withoutItTheResolutionDecidesAndTheScenarioDoesNotListIt() {
        Scenario scenario = Scenario.defaults().with("resolution=high");
        assertThat(OrganSettings.budget(scenario)).isEqualTo(Resolution.HIGH.budget());
        assertThat(scenario.toMap()).doesNotContainKey("mesh_vertices");
        assertThat(scenario.with("mesh_vertices=5000").toMap()).containsEntry("mesh_vertices", 5000L);
    }

    @Test
    void aBudgetForADiaphragmGivesItThatManyVertices() {
        assertThat(MeshBudget.ofDiaphragm(19_586).diaphragmVertices()).isEqualTo(19_586);
        assertThat(Resolution.MEDIUM.diaphragmVertices()).isEqualTo(8705);
    }

    /** Remeshed, the faces of a sheet are meshed apart; a coarse one then moves 4 % less. */
    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female", "high-colon-male"})
    void sheetsThatAreGeneratedAreKept(String preset) {
        List<MeshBudget> budgets = new ArrayList<>();
        Stream.of(Resolution.values()).map(Resolution::budget).forEach(budgets::add);
        IntStream.of(3870, 5803, 13_058, 19_586)
                .mapToObj(MeshBudget::ofDiaphragm)
                .forEach(budgets::add);
        for (MeshBudget budget : budgets) {
            TriangleMesh sheet = VirtualThorax.ofPreset(preset, budget)
                    .structuresOf(StructureKind.DIAPHRAGM)
                    .get(0)
                    .mesh();
            assertThat(Remeshing.isAdequate(sheet, budget.diaphragmVertices()))
                    .as("%d vertices for %d", sheet.vertexCount(), budget.diaphragmVertices())
                    .isTrue();
        }
    }

    @Test
    void tooFewVerticesAreRefused() {
        assertThatThrownBy(() -> Scenario.defaults().with("mesh_vertices=20"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 20, expected 1000 to 1000000");
    }
}
