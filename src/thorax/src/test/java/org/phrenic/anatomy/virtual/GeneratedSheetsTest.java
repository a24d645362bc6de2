package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.organ.Remeshing;

/** Diaphragms as the virtual bodies have them, generated without the body around them. */
class GeneratedSheetsTest {
    /** The shape of a preset's sheet, of which every mesh is made. */
    private static final Map<String, DiaphragmSheet> SHAPES = new ConcurrentHashMap<>();

    private static DiaphragmSheet shape(String preset) {
        VirtualThoraxParameters parameters = VirtualThoraxParameters.preset(preset);
        ChestWallShape wall = new ChestWallShape(parameters.chestWall(), new Spine(parameters.spine()));
        DiaphragmShape dome = new DiaphragmShape(parameters.diaphragm(), wall);
        return new DiaphragmSheet(parameters.diaphragm(), dome, wall);
    }

    private static TriangleMesh sheet(String preset, MeshBudget budget) {
        return SHAPES.computeIfAbsent(preset, GeneratedSheetsTest::shape).mesh(budget.diaphragmVertices());
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
            TriangleMesh sheet = sheet(preset, budget);
            assertThat(Remeshing.isAdequate(sheet, budget.diaphragmVertices()))
                    .as("%d vertices for %d", sheet.vertexCount(), budget.diaphragmVertices())
                    .isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female", "high-colon-male"})
    void theBodyHasTheSheetOfItsBudget(String preset) {
        TriangleMesh sheet = sheet(preset, Resolution.LOW.budget());
        TriangleMesh ofBody = VirtualThorax.ofPreset(preset, Resolution.LOW)
                .structuresOf(StructureKind.DIAPHRAGM)
                .get(0)
                .mesh();
        assertThat(ofBody.positions()).isEqualTo(sheet.positions());
        assertThat(ofBody.triangles()).isEqualTo(sheet.triangles());
    }
}
