package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

class BreathCycleTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"20, 0, 20", "20, 1, 20", "20, 3, 60", "20, 20, 160", "100, 1, 100", "100, 3, 160"})
    void eachBreathHasItsMomentsAsFarAsThereIsMemory(int phases, int breaths, int moments) {
        assertThat(BreathCycle.moments(phases, breaths)).isEqualTo(moments);
    }

    /** A recording of three breaths of 1.2 s. */
    @Test
    void everyBreathOfARecordingIsSeen() throws Exception {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= 72; i++) {
            double t = 0.05 * i;
            csv.append(String.format(Locale.ROOT, "%.2f,%.6f%n", t, Math.pow(Math.sin(Math.PI * t / 1.2), 2)));
        }
        Path trace = Files.writeString(folder.resolve("belt.csv"), csv.toString());
        Scenario scenario = Scenario.defaults().with("trace=" + trace, "mesh_vertices=2000", "liver=false");
        Map<Integer, Integer> ofBreath = new TreeMap<>();
        try (Simulation simulation =
                Simulation.of(scenario, VirtualThorax.ofPreset("adult-male", new MeshBudget(2000)))) {
            for (BreathMoment moment : BreathCycle.record(simulation, new SceneSurfaces(simulation), 4)) {
                int breath = (int) moment.frame().values()[Observation.COLUMNS.indexOf("breath")];
                ofBreath.merge(breath, 1, Integer::sum);
            }
        }
        assertThat(ofBreath).isEqualTo(Map.of(0, 4, 1, 4, 2, 4));
    }

    private static List<BreathMoment> moments(int count, double periodS, double breathS) {
        List<Surface> none = List.of();
        List<BreathMoment> moments = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double t = periodS * i / count;
            moments.add(new BreathMoment(TestFrames.of(none, t, Math.floor(t / breathS), 0), RespiratoryPhase.PAUSE));
        }
        return moments;
    }

    @Test
    void whatIsNotJudgedIsSaid() {
        assertThat(BreathCycle.limits(moments(1, 4, 4))).isEmpty();
        assertThat(BreathCycle.limits(moments(5, 4, 4)))
                .as("as many as are asked for")
                .isEmpty();
        assertThat(BreathCycle.limits(moments(20, 39, 39))).isEmpty();
        assertThat(BreathCycle.limits(moments(160, 36, 2))).isEmpty();
        assertThat(BreathCycle.limits(moments(160, 36, 1.5)))
                .contains("judged at 160 moments of the first 36 s, 6.7 a breath");
        assertThat(BreathCycle.limits(moments(160, 40, 4)))
                .contains("judged at 160 moments of the first 40 s, 16.0 a breath");
    }
}
