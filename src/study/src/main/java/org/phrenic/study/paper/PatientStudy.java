package org.phrenic.study.paper;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.Numbers;
import org.phrenic.fit.Fit;
import org.phrenic.fit.FitHalf;
import org.phrenic.fit.FitProgress;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.FitSetup;
import org.phrenic.fit.FitTarget;
import org.phrenic.fit.GroundTruth;
import org.phrenic.fit.SyntheticPatient;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.model.material.ActionLines;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.Attempts;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.fit.PatientImport;
import org.phrenic.study.fit.PatientScans;

/**
 * The paper's patient study on public scans: import of both breath levels, rigid alignment, and a short fit at low
 * resolution.
 */
public final class PatientStudy {
    /** Default folder of scans at two breath levels, relative to the working directory. */
    public static final Path DEFAULT_FOLDER = Path.of("..", "shared", "segmentations", "breath-pairs-true");
    /** Maximum number of patients; each takes about a minute. */
    public static final int MAX_PATIENTS = 3;

    /** Maximum number of simulated breaths in the search for each patient. */
    private static final int EVALUATIONS = 25;

    /**
     * The paper's method for patients: uniform springs and masses, ribs still, force along two action lines. Damping is
     * stronger than published, so that the held breath comes to rest; it does not change where.
     */
    private static final Scenario PAPER_METHOD = Scenario.defaults()
            .with(
                    "material=paper",
                    "tendon=plane",
                    "preset=deep",
                    "resolution=low",
                    "rib_rotation=0",
                    "damping_ns_per_m=0.5");

    private static final int THREADS = 2;
    private static final double NOISE_MM = 1;
    private final boolean quick;
    private final ProgressListener progress;

    /** @param quick whether to use the first patient only, without tuning, and a synthetic one on a coarse mesh */
    public PatientStudy(boolean quick, ProgressListener progress) {
        this.quick = quick;
        this.progress = progress;
    }

    /**
     * Studies real patients, at most {@link #MAX_PATIENTS}. A patient whose scans cannot be used is left out with the
     * reason.
     *
     * @param axes see {@link GeometryOverride#axes}; empty for the axes of the files
     */
    public Attempts<PatientCase> of(List<PatientScans> scans, Optional<String> axes) {
        List<PatientScans> pairs = scans.stream().filter(PatientScans::isPair).toList();
        int count = Math.min(quick ? 1 : MAX_PATIENTS, pairs.size());
        List<BatchRunner.Job<Supplier<PatientImport>>> imports = new ArrayList<>();
        for (PatientScans pair : pairs.subList(0, count)) {
            imports.add(new BatchRunner.Job<>(pair.name(), () -> imported(pair, axes)));
        }
        List<Supplier<PatientImport>> imported = BatchRunner.run(imports, THREADS, (done, of, what) -> {});
        Attempts<PatientCase> cases = new Attempts<>();
        for (int i = 0; i < count; i++) {
            Supplier<PatientImport> patient = imported.get(i);
            cases.add(pairs.get(i).name(), () -> fitted(patient.get()));
            progress.done(i + 1, count, pairs.get(i).name());
        }
        scans.stream()
                .filter(one -> !one.isPair())
                .forEach(one -> cases.add(one.name(), () -> fitted(PatientImport.of(one, axes))));
        cases.failures().forEach(progress::note);
        return cases;
    }

    private PatientCase fitted(PatientImport patient) {
        Scenario deep = Scenario.defaults().with("preset=deep", "resolution=low");
        List<FitTarget> targets = FitTarget.withBases(patient.targets());
        String alignment = patient.alignment().sentence();
        progress.note(patient.name() + ": a fit of " + evaluations() + " breaths");
        FitResult fit = fit(deep, FitParameter.defaults(deep), patient.body(), targets, alignment);
        progress.note(patient.name() + ": the paper's method, a fit of " + evaluations() + " breaths");
        FitResult paperFit = fit(PAPER_METHOD, paperParameters(), patient.body(), targets, alignment);
        return new PatientCase(
                patient.name(),
                "CT, two breath holds",
                false,
                patient.body(),
                patient.notes(),
                fit,
                Optional.of(paperFit));
    }

    /** The import of a patient; what failed in it is thrown where it is taken, so that the others go on. */
    private Supplier<PatientImport> imported(PatientScans pair, Optional<String> axes) {
        progress.note(pair.name() + ": import of both breath levels");
        try {
            PatientImport patient = PatientImport.of(pair, axes);
            return () -> patient;
        } catch (RuntimeException failure) {
            return () -> {
                throw failure;
            };
        }
    }

    /** Integrator and time step of the paper's method. */
    static String paperScheme() {
        return PaperScenarios.scheme(PAPER_METHOD);
    }

    /** A synthetic patient with a known breath, used if there are no scans. */
    public PatientCase synthetic() {
        SyntheticPatient patient = SyntheticPatient.five().get(0);
        progress.note("a synthetic patient: " + patient.name());
        List<String> settings = new ArrayList<>(List.of("anatomy=" + patient.anatomy(), "resolution=low"));
        if (quick) {
            settings.add(PaperScenarios.QUICK_MESH);
        }
        GroundTruth truth = quick
                ? GroundTruth.of(patient, settings, PatientCase.LUNGS, NOISE_MM, 1)
                : GroundTruth.of(patient, Resolution.MEDIUM, NOISE_MM, 1);
        Thorax body = patient.body(settings);
        Scenario base = Scenario.defaults().with("preset=deep").with(settings.toArray(String[]::new));
        FitResult fit = fit(
                base,
                FitParameter.defaults(base),
                body,
                FitTarget.withBases(truth.targets()),
                "none: both levels are of one body in one place");
        List<String> notes = List.of(
                "what a scan would show of a virtual body that breathes with settings that the fit does not know ("
                        + String.join(", ", patient.hidden()) + "), its surfaces halved and moved by noise of 1 mm",
                Numbers.format(
                        "the noise alone leaves %.2f mm, which no fit can be expected to undercut", truth.floorMm()));
        progress.done(1, 1, patient.name());
        return new PatientCase(patient.name(), "synthetic", true, body, notes, fit, Optional.empty());
    }

    private int evaluations() {
        return quick ? 1 : EVALUATIONS;
    }

    /** Intensity and radius of the action lines, which the paper sets by hand. */
    private static List<FitParameter> paperParameters() {
        return Stream.of(ActionLines.MUSCLE_FORCE, ActionLines.ACTION_RADIUS, ActionLines.FORCE_LEFT_OVER_RIGHT)
                .map(p -> FitParameter.of(p, PAPER_METHOD))
                .toList();
    }

    private FitResult fit(
            Scenario base, List<FitParameter> tuned, Thorax body, List<FitTarget> targets, String alignment) {
        FitSetup setup = new FitSetup(
                base,
                body,
                targets,
                tuned,
                new FitSetup.Options(
                        FitHalf.ALL, alignment, new FitSearch.Settings(1, evaluations()), quick ? 1 : THREADS, false));
        try {
            // The journal serves to resume long searches and is not needed for a short one.
            Path journal = Files.createTempDirectory("phrenic").resolve("journal.csv");
            try {
                return Fit.run(setup, journal, new Breaths());
            } finally {
                delete(journal.getParent());
            }
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Deletes a folder with all its files, because a fit may write more than its journal. */
    private static void delete(Path folder) throws IOException {
        List<Path> kept;
        try (Stream<Path> files = Files.list(folder)) {
            kept = files.toList();
        }
        for (Path file : kept) {
            Files.deleteIfExists(file);
        }
        Files.delete(folder);
    }

    /** Reports progress every twelfth breath. */
    private final class Breaths implements FitProgress {
        private static final int EVERY = 12;

        @Override
        public void evaluated(int count, int most, double bestMm, double initialMm) {
            if (count % EVERY == 0) {
                progress.note(Numbers.format("%d of %d breaths, %.2f mm of %.2f", count, most, bestMm, initialMm));
            }
        }
    }
}
