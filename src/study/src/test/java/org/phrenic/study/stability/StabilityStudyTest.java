package org.phrenic.study.stability;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.stability.CaseResult.Outcome;

/**
 * The short version of the hard cases: no scheme may fail in silence, and those known to be unfit must be refused or
 * split.
 */
class StabilityStudyTest {
    /** A cell of the short version ends after so many evaluations of the force on a node: a tenth of a second. */
    private static final double SPENT = 4e6;

    /** The body of the short version's cases. */
    private static final int VERTICES = 4000;

    private static final Scenario SMALL = Scenario.defaults().with("mesh_vertices=" + VERTICES, "threads=1");

    private static Thorax man() {
        return VirtualThorax.ofPreset("adult-male", new MeshBudget(VERTICES));
    }

    private static StabilityStudy run(List<String> only, double spent, IntegratorKind... kinds) {
        StabilityStudy.Settings settings =
                StabilityStudy.Settings.QUICK.only(only, Arrays.asList(kinds)).withEvaluations(spent);
        return StabilityStudy.of(settings.withThreads(2), (count, total, what) -> {});
    }

    private static List<String> domes() {
        return StabilityStudy.caseKeys(Optional.empty()).stream()
                .filter(key -> !isThorax(key))
                .toList();
    }

    private static boolean isThorax(String key) {
        return key.startsWith("thorax") || key.startsWith("sliders") || key.startsWith("hour");
    }

    @Test
    void noIntegratorFailsInSilenceOnADome() {
        StabilityStudy study = run(domes(), SPENT, IntegratorKind.values());
        assertThat(study.cells()).allSatisfy(c -> assertThat(c.outcome())
                .as(c.caseKey() + ", " + c.integrator().label() + ": " + c.sentence())
                .isNotIn(Outcome.SILENT_FAILURE, Outcome.NOT_RETURNED, Outcome.STOPPED));
        assertThat(study.passes()).isTrue();
        Map<String, Outcome> of = study.cells().stream()
                .collect(
                        Collectors.toMap(c -> c.caseKey() + " " + c.integrator().label(), CaseResult::outcome));
        // Both grow at every step without damping (docs/equations.md).
        assertThat(of.get("damping-0 rk2")).isEqualTo(Outcome.REFUSED);
        assertThat(of.get("damping-0 lagged")).isEqualTo(Outcome.REFUSED);
        assertThat(of.get("published verlet")).isEqualTo(Outcome.STABLE);
        assertThat(of.get("links-conflict verlet")).isEqualTo(Outcome.NOTICED);
        assertThat(of.get("coincident verlet")).isEqualTo(Outcome.REFUSED);
        // The published step of 0.01 s is beyond the limit of midpoint Runge-Kutta: it is split.
        assertThat(study.cells().stream()
                        .filter(c -> c.caseKey().equals("published") && c.integrator() == IntegratorKind.RK2)
                        .findFirst()
                        .orElseThrow()
                        .substeps())
                .isEqualTo(2);
    }

    @Test
    void theThoraxHoldsItsBoundsAndComesToRestAfterSlidersWereThrown() {
        StabilityStudy study =
                run(List.of("thorax-man-paper", "sliders-paper", "hour-paper"), 1e9, IntegratorKind.VERLET);
        assertThat(study.cells()).hasSize(3).allSatisfy(c -> assertThat(c.outcome())
                .as(c.caseKey() + ": " + c.sentence())
                .isIn(Outcome.STABLE, Outcome.RECOVERED));
    }

    /** From rest into expiration, which begins at 1.6 s; the scanned body is one of them where its files are. */
    @Test
    void theDefaultSceneOfEachBodyHoldsItsBounds() {
        Optional<String> scan = Optional.of("../shared/anatomy/male-thorax").filter(f -> Files.isDirectory(Path.of(f)));
        List<String> keys = scan.isPresent()
                ? List.of("thorax-man", "thorax-woman", "thorax-scanned")
                : List.of("thorax-man", "thorax-woman");
        StabilityStudy.Settings settings = StabilityStudy.Settings.QUICK
                .only(keys, List.of(IntegratorKind.VERLET))
                .withThreads(2)
                .withScan(scan);
        assertThat(StabilityStudy.of(settings, (count, total, what) -> {}).cells())
                .hasSize(keys.size())
                .allSatisfy(c -> assertThat(c.outcome())
                        .as(c.caseKey() + ": " + c.sentence())
                        .isEqualTo(Outcome.STABLE));
    }

    /** The reference solution lacks the contact as well, so only a measure of its own can notice that it is missing. */
    @Test
    void aSheetWithoutContactWithItsWallIsAFailure() {
        Scenario scenario = SMALL.with("preset=deep", "contact=false");
        StabilityCase.Factory free =
                (integrator, refinement, durationS) -> new ThoraxScene(scenario, man(), simulation -> {});
        StabilityCase deep = StabilityCases.all(true, Optional.empty()).stream()
                .filter(c -> c.key().equals("thorax-man-deep"))
                .findFirst()
                .orElseThrow();
        StabilityCase without =
                new StabilityCase(deep.key(), "", deep.bounds(), free, deep.durationS(), deep.quickS(), 0, 0);
        CaseResult cell = CaseRun.of(without, IntegratorKind.VERLET, null, deep.quickS(), 1e12);
        assertThat(cell.outcome()).as(cell.sentence()).isEqualTo(Outcome.SILENT_FAILURE);
        assertThat(cell.sentence()).contains("outside the chest wall");
    }

    /**
     * Nodes may pass each other by millimetres from breath to breath, but when the breath stops each is where it began.
     */
    @Test
    void thePapersSheetSwingsOnAndStillComesBackToItsRestShape() {
        StabilityCase hour = StabilityCases.all(true, Optional.empty()).stream()
                .filter(c -> c.key().equals("hour-paper"))
                .findFirst()
                .orElseThrow();
        CaseResult cell = CaseRun.of(hour, IntegratorKind.VERLET, null, 72, 1e12);
        assertThat(cell.outcome()).as(cell.sentence()).isEqualTo(Outcome.STABLE);
        assertThat(cell.value(StabilityMeasure.REPEAT_MM)).isGreaterThan(1);
        assertThat(cell.value(StabilityMeasure.DRIFT_MM)).isLessThan(1e-3);
        assertThat(cell.sentence()).contains("no breath repeats another").contains("come to rest within");
    }

    /**
     * What makes the breaths differ is the swing of a sheet that is hardly damped: with 0.5 N s/m each is the one
     * before.
     */
    @Test
    void withDampingThePapersBreathsRepeat() {
        Scenario scenario =
                SMALL.with("material=paper", "damping_ns_per_m=0.5", "lungs=off", "sternum=off", "liver=false");
        try (ThoraxScene trial = new ThoraxScene(scenario, man(), simulation -> {})) {
            NodeState shape = new NodeState(trial.system());
            double[] before = null;
            for (int breath = 1; breath <= 4; breath++) {
                before = shape.positions().clone();
                while (trial.stepper().time() < breath * 4 - 1e-9) {
                    trial.step();
                }
            }
            // Swings fade by e in 0.4 s: what the start left is e^-30 by then.
            assertThat(NodeState.maxDistance(shape.positions(), before)).isLessThan(1e-3);
        }
    }

    @Test
    void aBreachThatNobodyNoticedIsAFailure() {
        StabilityCase made = StabilityCases.all(true, Optional.empty()).get(0);
        StabilityCase strict = new StabilityCase(
                "strict",
                "",
                StabilityBounds.BODY.with(StabilityMeasure.SPEED_MM_S, 1),
                made.factory(),
                made.durationS(),
                made.quickS(),
                made.periodS(),
                0);
        CaseResult cell = CaseRun.of(strict, IntegratorKind.VERLET, null, 2, 1e9);
        assertThat(cell.outcome()).isEqualTo(Outcome.SILENT_FAILURE);
        assertThat(cell.sentence()).contains("speed of a node").contains("expected at most 1.000");
        StabilityStudy study = new StabilityStudy(Map.of("strict", ""), List.of(IntegratorKind.VERLET), List.of(cell));
        assertThat(study.passes()).isFalse();
        assertThat(MarkdownPage.format(new StabilityReport(study).document(List.of("Commit 1"))))
                .contains("1 FAILED SILENTLY")
                .contains("| strict | FAILED SILENTLY |");
    }

    @Test
    void reportsSayTheSameInEveryForm() {
        StabilityStudy study = run(List.of("damping-0"), SPENT, IntegratorKind.VERLET, IntegratorKind.RK2);
        StabilityReport report = new StabilityReport(study);
        assertThat(MarkdownPage.format(report.document(List.of("Commit 1"))))
                .contains("| damping-0 | stable | refused |");
        assertThat(report.csv())
                .startsWith("case,integrator,verdict,simulated_s")
                .contains("damping-0,rk2,refused");
        assertThat(report.values()).containsEntry("passes", true);
    }
}
