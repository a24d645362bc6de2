package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.Attempts;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.speed.SpeedCase;
import org.phrenic.study.speed.SpeedTable;
import org.phrenic.study.speed.SpeedTrials;

/**
 * All results of the paper that need no picture.
 *
 * @param quick whether the measurement was coarse and partial
 * @param breathResolution resolution of the breaths
 * @param defaultModel size of the default model at the finest measured resolution
 * @param publishedModel size of the model with the paper's numbers and rules, at the finest measured resolution
 * @param speed table 1
 * @param realTimeFactor simulated time over processor time of the published model, with its scheme and step, at the
 *     finest measured resolution
 * @param breaths by the labels of their runs
 */
public record Reproduction(
        boolean quick,
        Resolution breathResolution,
        ModelCounts defaultModel,
        ModelCounts publishedModel,
        SpeedTable speed,
        double realTimeFactor,
        Attempts<PaperBreath> breaths) {

    /** Simulated breaths. */
    public enum Run {
        LIGHT("light breath"),
        DEEP("deep breath"),
        DEEP_MUSCLE("deep breath, muscle alone"),
        DEEP_RIBS("deep breath, ribs and sternum alone"),
        PUBLISHED("deep breath, the published model"),
        PUBLISHED_THREE_LINKS("deep breath, the published model, three rigid links a node"),
        PUBLISHED_HOMOGENEOUS("deep breath, the published model, no rigid links");

        private final String label;

        Run(String label) {
            this.label = label;
        }

        /** Name in reports. */
        public String label() {
            return label;
        }

        /** Integrator and time step, as in {@code rk2, 10 ms}. */
        String scheme() {
            return PaperScenarios.scheme(scenario(Resolution.LOW));
        }

        private Scenario scenario(Resolution resolution) {
            Scenario scenario =
                    switch (this) {
                        case LIGHT -> PaperScenarios.defaultModel("quiet", resolution);
                        case DEEP -> PaperScenarios.defaultModel("deep", resolution);
                        case DEEP_MUSCLE ->
                            PaperScenarios.defaultModel("deep", resolution).with("ribs=false");
                        case DEEP_RIBS ->
                            PaperScenarios.defaultModel("deep", resolution)
                                    .with("muscle=false", "greatest_pressure_kpa=0");
                        case PUBLISHED -> PaperScenarios.publishedModel("deep", resolution);
                        case PUBLISHED_THREE_LINKS ->
                            PaperScenarios.publishedModel("deep", resolution).with("links_per_node=3");
                        case PUBLISHED_HOMOGENEOUS ->
                            PaperScenarios.publishedModel("deep", resolution).with("tensegrity=false");
                    };
            // The other runs are only evaluated at end-inspiration, which is 3 to 4 s after the start.
            boolean toTheEnd = this == LIGHT || this == DEEP || this == PUBLISHED;
            return toTheEnd ? scenario.with("threads=1") : scenario.with("threads=1", "duration_s=" + INSPIRED_S);
        }
    }

    private static final double INSPIRED_S = 5;

    private static final int THREADS = 2;
    private static final int TRIALS = 5;
    private static final double TRIAL_S = 0.3;
    private static final int QUICK_TRIALS = 3;
    private static final double QUICK_TRIAL_S = 0.02;
    private static final String[] AS_RESOLVED = {};
    private static final String[] COARSE = {PaperScenarios.QUICK_MESH};

    /**
     * The breath of a run, if it was simulated. The ribs alone do not lower the domes, so deep breaths of the default
     * model are compared at the end-inspiration of the complete one.
     */
    Optional<PaperBreath> breath(Run run) {
        Optional<PaperBreath> breath = breaths.result(run.label());
        Optional<PaperBreath> whole =
                run == Run.DEEP_MUSCLE || run == Run.DEEP_RIBS ? breaths.result(Run.DEEP.label()) : Optional.empty();
        return whole.isEmpty()
                ? breath
                : breath.map(part -> part.withEndInspirationRow(whole.get().endInspirationRow()));
    }

    /** Breaths that could not be simulated, with their reasons. */
    public List<String> failures() {
        return breaths.failures();
    }

    /**
     * Runs the reproduction.
     *
     * @param quick whether to use coarse meshes in place of low resolution, and fewer breaths; takes a few seconds, and
     *     the speeds are not accurate
     */
    public static Reproduction of(boolean quick, ProgressListener progress) {
        List<Resolution> resolutions = quick ? List.of(Resolution.LOW) : List.of(Resolution.values());
        List<Run> runs = quick ? List.of(Run.LIGHT, Run.PUBLISHED) : List.of(Run.values());
        int trials = quick ? QUICK_TRIALS : TRIALS;
        double trialS = quick ? QUICK_TRIAL_S : TRIAL_S;
        String[] mesh = quick ? COARSE : AS_RESOLVED;
        List<String> scheme = new ArrayList<>(SpeedTrials.SCHEME);
        scheme.addAll(List.of(mesh));
        int total = resolutions.size() + runs.size() + 1;
        List<SpeedTable.Row> speed = new ArrayList<>();
        Map<Resolution, Thorax> bodies = new LinkedHashMap<>();
        for (Resolution resolution : resolutions) {
            bodies.put(
                    resolution,
                    SimulationRun.loadThorax(
                            PaperScenarios.defaultModel("quiet", resolution).with(mesh)));
            speed.addAll(SpeedTrials.of(resolution, bodies.get(resolution), scheme, trials, trialS));
            progress.done(
                    speed.size() / SpeedCase.values().length,
                    total,
                    "speed, " + speed.get(speed.size() - 1).vertices() + " vertices");
        }
        Resolution finest = resolutions.get(resolutions.size() - 1);
        Scenario published = PaperScenarios.publishedModel("quiet", finest).with(mesh);
        double realTime =
                SpeedTrials.realTimeFactor(published.with("preset=deep", "threads=1"), bodies.get(finest), trialS);
        ModelCounts own =
                ModelCounts.of(PaperScenarios.defaultModel("quiet", finest).with(mesh), bodies.get(finest));
        ModelCounts asPublished = ModelCounts.of(published, bodies.get(finest));
        progress.done(resolutions.size() + 1, total, "size of the model");
        Resolution breathing = quick ? Resolution.LOW : Resolution.MEDIUM;
        List<BatchRunner.Job<PaperBreath>> jobs = runs.stream()
                .map(run -> new BatchRunner.Job<>(
                        run.label(),
                        () -> PaperBreath.of(run.scenario(breathing).with(mesh), bodies.get(breathing))))
                .toList();
        Attempts<PaperBreath> breaths =
                Attempts.of(jobs, THREADS, (count, of, what) -> progress.done(total - of + count, total, what));
        breaths.failures().forEach(progress::note);
        return new Reproduction(quick, breathing, own, asPublished, new SpeedTable(speed), realTime, breaths);
    }
}
