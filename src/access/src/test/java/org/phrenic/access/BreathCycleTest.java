package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

class BreathCycleTest {
    private static final long PATIENCE_S = 60;

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"20, 4, 20", "20, 1.333, 60", "20, 0.2, 160", "100, 4, 100", "100, 1.333, 160", "2, 3.999, 2"})
    void theShortestBreathHasItsMomentsAsFarAsThereIsMemory(int phases, double shortestBreathS, int moments) {
        assertThat(BreathCycle.moments(phases, 4, shortestBreathS)).isEqualTo(moments);
    }

    /** A recording of three breaths of 1.2 s, headless and live. */
    @Test
    void everyBreathOfARecordingIsSeen() throws Exception {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= 72; i++) {
            double t = 0.05 * i;
            csv.append(String.format(Locale.ROOT, "%.2f,%.6f%n", t, Math.pow(Math.sin(Math.PI * t / 1.2), 2)));
        }
        Path trace = Files.writeString(folder.resolve("belt.csv"), csv.toString());
        Scenario scenario = Scenario.defaults().with("trace=" + trace, "mesh_vertices=2000", "liver=false");
        List<BreathMoment> headless;
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            headless = BreathCycle.record(simulation, new SceneSurfaces(simulation), 4);
        }
        Map<Integer, Integer> ofBreath = new TreeMap<>();
        for (BreathMoment moment : headless) {
            int breath = (int) moment.frame().values()[Observation.COLUMNS.indexOf("breath")];
            ofBreath.merge(breath, 1, Integer::sum);
        }
        assertThat(ofBreath).isEqualTo(Map.of(0, 4, 1, 4, 2, 4));
        List<BreathMoment> live = live(scenario, 4);
        assertThat(live).hasSameSizeAs(headless);
        for (int m = 0; m < live.size(); m++) {
            assertThat(live.get(m).label()).isEqualTo(headless.get(m).label());
            assertThat(live.get(m).periodS()).isEqualTo(headless.get(m).periodS());
            assertThat(live.get(m).frame().values())
                    .isEqualTo(headless.get(m).frame().values());
        }
    }

    private static List<BreathMoment> live(Scenario scenario, int phases) throws Exception {
        CompletableFuture<LiveScene> loaded = new CompletableFuture<>();
        LiveRun run = new LiveRun(scenario, new FirstScene(loaded));
        try {
            Frame ofScene = loaded.get(PATIENCE_S, TimeUnit.SECONDS).newFrame().get();
            CompletableFuture<List<BreathMoment>> cycle = new CompletableFuture<>();
            CycleRecorder recorder = new CycleRecorder(run, ofScene, phases, share -> {}, cycle::complete);
            run.setSpeed(Double.POSITIVE_INFINITY);
            run.restart(recorder, recorder);
            run.play();
            return cycle.get(PATIENCE_S, TimeUnit.SECONDS);
        } finally {
            run.close();
        }
    }

    /** Moments of breaths that pause for their last fifth, of which the last goes on to the end. */
    private static List<BreathMoment> moments(int count, double periodS, double breathS, int breaths) {
        List<Surface> none = List.of();
        List<BreathMoment> moments = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double t = Math.min(periodS, 40) * i / count;
            double breath = Math.min(Math.floor(t / breathS), breaths - 1);
            boolean pause = t / breathS - breath >= 0.8;
            moments.add(new BreathMoment(
                    TestFrames.of(none, t, breath, 0),
                    pause ? RespiratoryPhase.PAUSE : RespiratoryPhase.EXPIRATION,
                    periodS));
        }
        return moments;
    }

    @ParameterizedTest
    @CsvSource(
            nullValues = "-",
            delimiter = '|',
            value = {
                "1 | 4 | 4 | 1 | -",
                "5 | 4 | 4 | 1 | -",
                "20 | 39 | 39 | 1 | -",
                "160 | 40 | 2.5 | 16 | -",
                "60 | 12 | 4 | 3 | -",
                // The mean is 20 a breath, that of the short breaths 6.
                "160 | 36 | 1.5 | 8 | judged at 160 moments of 36 s, at least 5",
                "20 | 4 | 1 | 1 | judged at 20 moments of 4 s, at least 4",
                "160 | 40.5 | 4 | 11 | judged at 160 moments of the first 40 s, at least 13",
                // What is recorded of the last breath is not all of it.
                "160 | 60 | 3.9 | 20 | judged at 160 moments of the first 40 s, at least 12",
                "160 | 60 | 60 | 1 | judged at 160 moments of the first 40 s, at least 160"
            })
    void whatIsNotJudgedIsSaid(int count, double periodS, double breathS, int breaths, String limits) {
        assertThat(BreathCycle.limits(moments(count, periodS, breathS, breaths)))
                .isEqualTo(
                        Optional.ofNullable(limits).map(text -> text + " of each breath outside of pauses and holds"));
    }
}
