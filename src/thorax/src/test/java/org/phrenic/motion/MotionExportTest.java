package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** What an export says before it breathes. */
class MotionExportTest {
    private static final Path CT = Path.of("ct.mha");
    private static final long GB = 1L << 30;

    private static MotionRequest request(double gridMm, Path image, boolean more) {
        return new MotionRequest(gridMm, null, image, false, more, more && gridMm > 0, "mha");
    }

    @Test
    void theSpaceOfATimeIsThatOfAllItsFiles() {
        assertThat(MotionExport.bytesATime(request(3, null, false), 1000, 0, 0)).isEqualTo(24_000);
        assertThat(MotionExport.bytesATime(request(3, null, true), 1000, 0, 0)).isEqualTo(33_000);
        assertThat(MotionExport.bytesATime(request(0, CT, false), 0, 1000, 4)).isEqualTo(4000);
        assertThat(MotionExport.bytesATime(request(0, CT, true), 0, 1000, 2)).isEqualTo(10_000);
        assertThat(MotionExport.bytesATime(request(3, CT, true), 1000, 1000, 2)).isEqualTo(35_000);
    }

    @Test
    void anImageThatDoesNotFitIntoMemoryIsRefusedWithoutAGrid() {
        assertThatThrownBy(() -> MotionExport.checkMemory(0, 100_000_000, GB))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith("--warp: found 100000000 voxels, expected no more");
        assertThatThrownBy(() -> MotionExport.checkMemory(100_000_000, 0, GB))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith("--grid: found 100000000 voxels, expected no more");
        assertThatThrownBy(() -> MotionExport.checkMemory(9000, 100_000_000, GB))
                .as("a small grid for a large image")
                .hasMessageStartingWith("--warp: found 100000000 voxels");
        assertThatCode(() -> MotionExport.checkMemory(1_000_000, 1_000_000, GB)).doesNotThrowAnyException();
    }

    /** Without a skin nothing tells the chest wall from the air before it. */
    @Test
    void aBodyWithoutASkinIsNoted() {
        Thorax man = VirtualThorax.ofPreset("adult-male", new MeshBudget(2000));
        Thorax bare = new Thorax(
                man.name(),
                man.structures().stream()
                        .filter(s -> s.kind() == StructureKind.DIAPHRAGM || s.kind() == StructureKind.RIB)
                        .toList(),
                man.notes());
        Scenario scenario =
                Scenario.defaults().with("mesh_vertices=2000", "lungs=off", "sternum=off", "liver=false", "threads=1");
        try (Simulation simulation = Simulation.of(scenario, bare);
                BodyMotion motion = new BodyMotion(simulation, false, LungInside.VERTICES, 1)) {
            assertThat(notes(simulation, motion))
                    .containsExactly("The body has no skin, so that its soft tissue counts as outside.");
        }
    }

    /** What an export of a body says before it breathes. */
    static List<String> notes(Simulation simulation, BodyMotion motion) {
        List<String> notes = new ArrayList<>();
        SimulationRun.Progress progress = new SimulationRun.Progress() {
            @Override
            public void advanced(double simulatedS, double totalS, double stepsPerS) {}

            @Override
            public void note(String sentence) {
                notes.add(sentence);
            }
        };
        new MotionExport(simulation, motion, request(50, null, false), Path.of("out"), progress);
        return notes;
    }
}
