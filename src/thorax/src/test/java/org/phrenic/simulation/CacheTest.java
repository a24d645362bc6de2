package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.UserCache;
import org.phrenic.scenario.Scenario;

/** A body and a settled shape from the cache give the bits of those that are computed. */
class CacheTest {
    @TempDir
    Path folder;

    private long entries(String kind) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().startsWith(kind))
                    .count();
        }
    }

    @Test
    void aCachedBodyIsTheGeneratedOne() throws IOException {
        UserCache cache = UserCache.in(folder, "build");
        // sizes that no other test asks for, so that the process does not hold the bodies yet
        Thorax generated = VirtualThorax.ofPreset("adult-female", new MeshBudget(2_011), cache);
        assertThat(entries("body")).isEqualTo(1);
        Path entry;
        try (Stream<Path> files = Files.list(folder)) {
            entry = files.findFirst().orElseThrow();
        }
        byte[] written = Files.readAllBytes(entry);
        assertThat(VirtualThorax.read(cache, "adult-male", new MeshBudget(2_011)))
                .isEmpty();
        assertThat(VirtualThorax.read(cache, "adult-female", new MeshBudget(2_012)))
                .isEmpty();

        Thorax read =
                VirtualThorax.read(cache, "adult-female", new MeshBudget(2_011)).orElseThrow();
        assertThat(Files.readAllBytes(entry)).isEqualTo(written);
        assertThat(read.name()).isEqualTo(generated.name());
        assertThat(read.notes()).isEqualTo(generated.notes());
        assertThat(read.structures()).hasSameSizeAs(generated.structures());
        for (int i = 0; i < read.structures().size(); i++) {
            Structure a = generated.structures().get(i);
            Structure b = read.structures().get(i);
            assertThat(b.withMesh(a.mesh())).isEqualTo(a);
            assertThat(b.mesh().positions()).isEqualTo(a.mesh().positions());
            assertThat(b.mesh().triangles()).isEqualTo(a.mesh().triangles());
        }
    }

    @Test
    void aCachedSceneBreathesBitForBitAsTheOneThatIsComputed() {
        UserCache cache = UserCache.in(folder, "build");
        Scenario scenario = Runs.scenario("threads=1");
        String computed = stateAfterSteps(scenario, UserCache.off());
        assertThat(stateAfterSteps(scenario, cache)).isEqualTo(computed);
        assertThat(stateAfterSteps(scenario, cache)).as("from the cache").isEqualTo(computed);
    }

    @Test
    void anEntryServesEveryRunOfASceneAndNoOtherBody() throws IOException {
        UserCache cache = UserCache.in(folder, "build");
        Scenario scenario = Runs.scenario(Runs.sheetAlone("threads=1", "material=paper"));
        String computed = stateAfterSteps(scenario, cache);
        Scenario longer = scenario.with("name=other", "threads=2", "duration_s=3", "record_every_s=0.5");
        assertThat(stateAfterSteps(longer, cache)).as("from the cache").isEqualTo(computed);
        assertThat(entries("scene")).isEqualTo(1);

        Thorax male = Runs.male();
        Structure first = male.structures().get(0);
        double[] moved = first.mesh().positions().clone();
        moved[0] += 1e-6;
        Structure other = first.withMesh(first.mesh().withPositions(moved));
        List<Structure> structures = new ArrayList<>(male.structures());
        structures.set(0, other);
        Simulation.of(scenario, new Thorax(male.name(), structures, male.notes()), cache)
                .close();
        assertThat(entries("scene")).isEqualTo(2);
    }

    private static String stateAfterSteps(Scenario scenario, UserCache cache) {
        try (Simulation simulation = Simulation.of(scenario, Runs.male(), cache)) {
            for (int i = 0; i < 40; i++) {
                simulation.step();
            }
            return simulation.stateHash() + simulation.settlingDisplacementMm();
        }
    }
}
