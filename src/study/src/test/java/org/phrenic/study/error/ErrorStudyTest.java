package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.scenario.Scenario;

/** The sheet of the paper's material, for a fifth of a second: all that is measured must fall as it should. */
class ErrorStudyTest {
    private static final Scenario SHEET = Scenario.defaults()
            .with("material=paper", "resolution=low", "lungs=embedded", "sternum=kinematic", "threads=1");
    /** What rounding of places near 100 mm leaves of a distance of micrometres. */
    private static final double ROUNDING = 1e-6;

    private static ErrorStudy study;

    @BeforeAll
    static void measure() {
        SolverGrid grid = new SolverGrid(
                List.of(IntegratorKind.VERLET, IntegratorKind.LAGGED),
                List.of(0.0025, 0.005, 0.01),
                List.of(1, 2),
                List.of(0.0025),
                true);
        study = ErrorStudy.of(SHEET, grid, true, (count, total, what) -> {});
    }

    private static double rms(double stepS, int sweeps) {
        SolverSettings wanted = new SolverSettings(IntegratorKind.VERLET, stepS, sweeps, 0.0025);
        return study.points().stream()
                .filter(p -> p.settings().equals(wanted))
                .findFirst()
                .orElseThrow()
                .rmsMm();
    }

    @Test
    void theReferenceIsNearerToItselfWithTwiceTheStepThanAnySettingIs() {
        assertThat(study.referenceUncertainty()[0]).isLessThan(0.5 * rms(0.0025, 1));
    }

    @Test
    void theErrorFallsWithTheStep() {
        assertThat(rms(0.005, 1)).isLessThan(rms(0.01, 1));
        assertThat(rms(0.0025, 1)).isLessThan(rms(0.005, 1));
    }

    @Test
    void withOneLinkANodeASecondSweepChangesNothing() {
        assertThat(rms(0.005, 2)).isCloseTo(rms(0.005, 1), within(ROUNDING * rms(0.005, 1)));
    }

    @Test
    void theScenariosOwnSettingIsAmongThemAndMarked() {
        assertThat(study.points().stream().filter(ErrorPoint::isDefault).map(ErrorPoint::settings))
                .containsExactly(SolverSettings.of(SHEET));
    }

    /** As in the table of the whole error, whatever else the machine does. */
    @Test
    void speedOnOneThreadIsSimulatedTimeOverProcessorTime() {
        assertThat(study.points()).allSatisfy(p -> assertThat(p.realTime()).isEqualTo(study.simulatedS() / p.cpuS()));
    }

    @Test
    void aStepThatIsSplitIntoThoseOfAShorterOneIsLeftOutWithTheReason() {
        assertThat(study.skipped())
                .isNotEmpty()
                .allMatch(line ->
                        line.startsWith("lagged") && line.matches(".* 2 sweeps.* is split into \\d+ substeps.*"));
    }

    @Test
    void theReportHasALineASettingAndTheJsonTheSame() {
        assertThat(ErrorReport.cells(study)).hasSameSizeAs(study.points());
        assertThat(ErrorReport.heading(study))
                .contains("nodes of the virtual adult male, 0.2 s of a breath, preset quiet");
        assertThat(new ErrorReport(List.of(study), Map.of()).values().toString())
                .contains("reference_halving_rms_mm", "until_s=0.2");
    }

    /** What costs less and errs less than can be measured leaves nothing to choose among what costs more. */
    @Test
    void theFrontHoldsNothingThatASettingWithAnUnresolvedErrorBeats() {
        List<ErrorPoint> points = List.of(point(0.5, 0.02), point(1, 0.001), point(2, 0.01), point(3, 0.002));
        assertThat(ErrorStudy.withParetoFront(points, 0.003))
                .extracting(ErrorPoint::paretoOptimal)
                .containsExactly(true, false, false, false);
        assertThat(ErrorStudy.withParetoFront(points, 0.0005))
                .extracting(ErrorPoint::paretoOptimal)
                .containsExactly(true, true, false, false);
    }

    private static ErrorPoint point(double cpuS, double rmsMm) {
        return new ErrorPoint(SolverSettings.of(SHEET), 1, rmsMm, 0, 0, 0, 0, cpuS, 0, 0, false, false);
    }

    @Test
    void anErrorBelowThreeTimesTheUncertaintyOfTheReferenceIsNotResolved() {
        double shortest = rms(0.0025, 1);
        double[] uncertain = {0.5 * shortest, 1, 1, 1};
        ErrorStudy known = new ErrorStudy(
                study.scenario(),
                study.nodes(),
                study.simulatedS(),
                study.excursionsMm(),
                study.reference(),
                uncertain,
                study.points(),
                List.of(),
                List.of());
        assertThat(known.points())
                .allSatisfy(p -> assertThat(known.isResolved(p)).isEqualTo(p.rmsMm() >= 1.5 * shortest));
        assertThat(ErrorReport.heading(known)).contains("not resolved");
    }
}
