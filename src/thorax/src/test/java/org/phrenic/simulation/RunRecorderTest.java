package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FolderLock;
import org.phrenic.file.Hashes;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.PvdSeries;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.observe.Observation;

/** What a run leaves behind; the paper's material on a coarse mesh, for it is quick. */
class RunRecorderTest {
    private static final int VERTICES = 2000;

    @TempDir
    Path folder;

    private static Scenario scenario(String... more) {
        return Runs.scenario(Runs.sheetAlone(
                        "mesh_vertices=" + VERTICES,
                        "material=paper",
                        "pressure=false",
                        "preset=sniff",
                        "duration_s=0.1",
                        "record_every_s=0.02"))
                .with(more);
    }

    private static Map<String, Object> execute(Scenario scenario, Path out) {
        return SimulationRun.run(scenario, out, (at, of, perS) -> {});
    }

    @Test
    void aRunLeavesSummaryObservablesScenarioAndMeshesAndTheScenarioGivesTheSameBitsAgain() throws IOException {
        Path out = folder.resolve("new/out");
        Map<String, Object> summary = execute(scenario("meshes_every_s=0.05"), out);
        assertThat(Files.readString(out.resolve("summary.json")))
                .contains("\"state_sha256\": \"" + summary.get("state_sha256") + "\"")
                .contains("\"made_by\"")
                .contains("Not for clinical use");
        List<String> lines = Files.readAllLines(out.resolve("observables.csv"));
        assertThat(lines.get(0)).isEqualTo(String.join(",", Observation.COLUMNS));
        // Samples at 0, 0.02 ... 0.1.
        assertThat(lines).hasSize(1 + 6);
        meshes(out);
        try (Stream<Path> all = Files.walk(out)) {
            assertThat(all.map(p -> p.getFileName().toString()))
                    .as("nothing half written is left")
                    .noneMatch(n -> n.endsWith(".tmp") || n.endsWith(".part") || n.startsWith("."));
        }
        Scenario again = Scenario.read(out.resolve("scenario.yaml"));
        assertThat(execute(again, null).get("state_sha256")).isEqualTo(summary.get("state_sha256"));
    }

    @Test
    void whatIsMeasuredOnAnOrganThatTheSceneLacksIsNeitherInTheTableNorInTheSummary() throws IOException {
        List<String> lacking = List.of("liver_si_mm", "liver_ap_mm", "liver_lr_mm", "lung_volume_change_ml");
        Path out = folder.resolve("out");
        Map<String, Object> whole = execute(scenario(), null);
        Map<String, Object> summary = execute(scenario("liver=false", "lungs=off"), out);
        CsvTable table = CsvTable.read(out.resolve("observables.csv"));
        for (String column : Observation.COLUMNS) {
            assertThat(table.texts(column)).as(column).allMatch(cell -> cell.isEmpty() == lacking.contains(column));
        }
        assertThat(whole).containsKeys(lacking.toArray(String[]::new));
        Set<String> left = new LinkedHashSet<>(whole.keySet());
        lacking.forEach(key -> left.removeAll(Set.of(key, RunSummary.peakToPeakKey(key))));
        assertThat(summary.keySet()).isEqualTo(left);
        assertThat(Files.readString(out.resolve("summary.json"))).doesNotContain("liver_", "lung_volume");
    }

    /** Meshes every 0.03 s in steps of 10 ms, samples every 0.1 s. */
    @Test
    void meshesAreWrittenAtTheirOwnIntervalWhateverTheSamples() throws IOException {
        Path out = folder.resolve("out");
        execute(scenario("record_every_s=0.1", "meshes_every_s=0.03"), out);
        assertThat(Files.readAllLines(out.resolve("observables.csv"))).hasSize(1 + 2);
        List<Double> times = frameTimes(out);
        assertThat(times).hasSize(4);
        for (int frame = 0; frame < 4; frame++) {
            assertThat(times.get(frame)).isCloseTo(0.03 * frame, within(1e-9));
        }
    }

    private static List<Double> frameTimes(Path out) throws IOException {
        return Files.readAllLines(out.resolve("scene.pvd")).stream()
                .filter(line -> line.contains("meshes/diaphragm_"))
                .map(line -> Double.valueOf(line.replaceAll(".*timestep=\"([^\"]*)\".*", "$1")))
                .toList();
    }

    /**
     * After five steps of 2.5 ms the step is 10 ms: 29 steps more reach 0.3 s. What is written changes neither the end
     * nor the state.
     */
    @Test
    void aRunWhoseStepChangesEndsAtItsTimeWhateverIsWritten() throws IOException {
        Scenario changed = scenario("time_step_s=0.0025", "duration_s=0.3", "record_every_s=0.3")
                .withChanges(List.of(ScheduledChange.parse("5:time_step_s=0.01")));
        Map<String, Object> without = execute(changed, null);
        assertThat(without).containsEntry("steps", 34L);
        Path out = folder.resolve("out");
        assertThat(execute(changed.with("meshes_every_s=0.1"), out))
                .containsEntry("steps", 34L)
                .containsEntry("state_sha256", without.get("state_sha256"));
        assertThat(execute(changed.with("record_every_s=0.02"), null))
                .containsEntry("steps", 34L)
                .containsEntry("state_sha256", without.get("state_sha256"));
        assertThat(frameTimes(out)).hasSize(4).allSatisfy(time -> assertThat(time % 0.1)
                .as("at most a step late")
                .isLessThan(0.01));
    }

    /** At 19 breaths/min two breaths take 6.3158 s, 2526.3 steps of 2.5 ms; the 2527th ends the second breath. */
    @Test
    void aRunOfTwoBreathsHasTwoWholeBreathsAtAnyRate() {
        Scenario twoBreaths = Runs.scenario(Runs.sheetAlone(
                "mesh_vertices=2000",
                "material=paper",
                "pressure=false",
                "rate_per_min=19",
                "time_step_s=0.0025",
                "record_every_s=0.05"));
        assertThat(execute(twoBreaths, null)).containsEntry("breaths", 2).containsEntry("steps", 2527L);
    }

    /** As far as the last step of the same two breaths. */
    @Test
    void aChangeMayBeScheduledForTheLastStepAtAnyRate() {
        Scenario twoBreaths = scenario("preset=quiet", "rate_per_min=19", "time_step_s=0.0025")
                .without(RunSettings.DURATION);
        ScheduleCheck.require(twoBreaths.withChanges(List.of(ScheduledChange.parse("2527:depth=0.5"))));
        Scenario late = twoBreaths.withChanges(List.of(ScheduledChange.parse("2528:depth=0.5")));
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ScheduleCheck.require(late))
                .withMessageContaining("at most step 2527");
    }

    private static void meshes(Path out) throws IOException {
        String index = Files.readString(out.resolve("scene.pvd"));
        try (Stream<Path> files = Files.list(out.resolve("meshes"))) {
            for (Path file : files.toList()) {
                assertThat(index).contains("file=\"meshes/" + file.getFileName() + "\"");
                assertThat(MeshFiles.read(file).triangleCount()).isPositive();
            }
        }
        // Frames at 0, which is rest, 0.05 and 0.1.
        Path file = out.resolve("meshes/diaphragm_00002.vtp");
        TriangleMesh last = MeshFiles.read(file);
        double[] rest =
                MeshFiles.read(out.resolve("meshes/diaphragm_00000.vtp")).positions();
        double[] displacement = last.positions().clone();
        Arrays.setAll(displacement, i -> displacement[i] - rest[i]);
        Diaphragm sheet = Diaphragm.withTrefoilTendon(diaphragm());
        double[] tendon = new double[last.vertexCount()];
        Arrays.setAll(tendon, i -> sheet.isTendon(i) ? 1 : 0);
        assertThat(tendon).hasSize(diaphragm().vertexCount()).contains(1).contains(0);
        Map<String, double[]> data = new LinkedHashMap<>();
        data.put("displacement_mm", displacement);
        data.put("tendon", tendon);
        Path expected = out.resolve("expected.vtp");
        VtpWriter.write(expected, last, data);
        assertThat(file).hasSameBinaryContentAs(expected);
        assertThat(out.resolve("meshes/rib_05_R_00000.vtp")).exists();
        assertThat(out.resolve("meshes/lung_L_00001.vtp")).exists();
        assertThat(out.resolve("meshes/liver_00002.vtp")).exists();
    }

    private static TriangleMesh diaphragm() {
        Thorax man = VirtualThorax.ofPreset("adult-male", new MeshBudget(VERTICES));
        return Runs.assembled(scenario(), man).diaphragm().diaphragm.sheet();
    }

    @Test
    void aRunThatFailsLeavesNoSummaryNotEvenAnEarlierOne() throws IOException {
        Path out = Files.createDirectory(folder.resolve("out"));
        Files.writeString(out.resolve("summary.json"), "{}");
        Files.writeString(out.resolve("meshes"), "a file where the folder of meshes should be");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> execute(scenario("meshes_every_s=0.05"), out))
                .withMessageContaining("meshes");
        assertThat(out.resolve("summary.json")).doesNotExist();
    }

    @Test
    void aRunThatDoesNotEndLeavesAnEarlierResultAsItIs() throws IOException {
        Path out = folder.resolve("kept");
        execute(scenario("meshes_every_s=0.05"), out);
        Map<Path, String> before = contents(out);
        SimulationRun.Progress stopping = (at, of, perS) -> {
            throw new IllegalStateException("stopped");
        };
        assertThatExceptionOfType(IllegalStateException.class)
                .isThrownBy(() -> SimulationRun.run(scenario("meshes_every_s=0.02", "depth=0.5"), out, stopping));
        Map<Path, String> after = contents(out);
        after.keySet().removeIf(file -> file.startsWith(out.resolve("meshes.part")));
        assertThat(after).isEqualTo(before);
        assertThat(out.resolve("meshes.part")).exists();
        execute(scenario(), out);
        assertThat(out.resolve("meshes.part")).doesNotExist();
        assertThat(out.resolve("meshes/diaphragm_00000.vtp")).doesNotExist();
    }

    @Test
    void aRunReplacesTheMeshesOfOneThatWasStoppedWhileItMovedThem() throws IOException {
        Path out = folder.resolve("stopped");
        Path obstacle = out.resolve("meshes/lung_R_00001.vtp");
        SimulationRun.Progress stopping = new SimulationRun.Progress() {
            @Override
            public void advanced(double simulatedS, double totalS, double stepsPerS) {}

            @Override
            public void measured(Map<String, Object> summary) {
                obstacle.toFile().mkdirs();
            }
        };
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> SimulationRun.run(scenario("meshes_every_s=0.05"), out, stopping))
                .withMessageContaining("lung_R_00001.vtp");
        assertThat(out.resolve("meshes/diaphragm_00001.vtp")).exists();
        assertThat(out.resolve("summary.json")).doesNotExist();
        Files.delete(obstacle);
        execute(scenario("meshes_every_s=0.05"), out);
        meshes(out);
    }

    @Test
    void aFileThatHasTheNameOfAMeshStopsTheRunBeforeItsFirstStep() throws IOException {
        Path out = folder.resolve("taken");
        Path own = Files.createDirectories(out.resolve("meshes")).resolve("liver_00003.vtp");
        Files.writeString(own, "the user's");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> SimulationRun.run(scenario("meshes_every_s=0.03"), out, (at, of, perS) -> {
                    throw new IllegalStateException("a step was made");
                }))
                .withMessageStartingWith(own + ": found a file that no run has listed in scene.pvd");
        assertThat(own).hasContent("the user's");
        execute(scenario("meshes_every_s=0.1"), out);
        assertThat(own).hasContent("the user's");
    }

    /** Steps of 10 ms up to 0.05 s, each with meshes, then of 1.25 ms, every other with meshes. */
    @Test
    void meshesComeAtTheirIntervalAfterTheStepBecomesSmaller() throws IOException {
        Path out = folder.resolve("finer");
        execute(
                scenario("time_step_s=0.01", "duration_s=0.06", "meshes_every_s=0.0025")
                        .withChanges(List.of(ScheduledChange.parse("5:time_step_s=0.00125"))),
                out);
        assertThat(frameTimes(out)).hasSize(1 + 5 + 4);
    }

    private static Map<Path, String> contents(Path folder) throws IOException {
        Map<Path, String> contents = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder).filter(Files::isRegularFile)) {
            for (Path file : files.toList()) {
                contents.put(file, Hashes.sha256(file));
            }
        }
        return contents;
    }

    @Test
    void whereNothingCanBeWrittenTheSentenceNamesThePlace() throws IOException {
        Path file = Files.writeString(folder.resolve("taken"), "");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> execute(scenario(), file.resolve("out")))
                .withMessageContaining("taken");
    }

    @Test
    void aFolderThatAnotherRunWritesIntoIsRefusedAndKeepsItsFiles() throws IOException {
        Path out = folder.resolve("busy");
        try (FolderLock other = FolderLock.of(out)) {
            Files.writeString(other.folder().resolve("summary.json"), "{}");
            assertThatExceptionOfType(BadInputException.class)
                    .isThrownBy(() -> execute(scenario(), out))
                    .withMessageContaining("another run");
            assertThat(out.resolve("summary.json")).exists();
        }
        assertThat(execute(scenario(), out)).containsKey("state_sha256");
    }

    @Test
    void meshesOfAnEarlierRunDoNotStayBesideANewSummary() throws IOException {
        Path out = Files.createDirectory(folder.resolve("again"));
        Path meshes = Files.createDirectory(out.resolve("meshes"));
        Path longer = Files.writeString(meshes.resolve("lung_L_00007.vtp"), "of a longer run");
        Path scan = Files.writeString(meshes.resolve("liver_20240115.vtp"), "the user's");
        Path own = Files.writeString(meshes.resolve("notes.txt"), "the user's");
        Path body = Files.writeString(meshes.resolve("costal_cartilage_03_L.vtp"), "of the user's body");
        PvdSeries series = new PvdSeries(out.resolve("scene.pvd"));
        series.add(7, longer);
        series.write();
        execute(scenario(), out);
        assertThat(longer).doesNotExist();
        assertThat(scan).exists();
        assertThat(out.resolve("scene.pvd")).doesNotExist();
        assertThat(own).exists();
        assertThat(body).exists();
    }
}
