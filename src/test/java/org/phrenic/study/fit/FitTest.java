package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.format.BadInputException;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;

/** A short form of a fit to a known breath: the sheet alone, three parameters, one generation. {@code phrenic fit --synthetic 5} is the long one. */
class FitTest {
    private static final String[] SHEET_ALONE = {
        "preset=deep", "resolution=low", "lungs=off", "sternum=off", "liver=false", "threads=1"
    };

    private static Scenario base;
    private static Thorax body;
    private static SyntheticTruth truth;

    @TempDir
    Path folder;

    @BeforeAll
    static void breathe() {
        SyntheticPatient patient = new SyntheticPatient(
                "test",
                "virtual/adult-male",
                1,
                1.05,
                1,
                -0.05,
                List.of("muscle_activation=0.4", "left_over_right=0.9", "rib_rotation=0.6", "lungs=off", "liver=false"));
        truth = SyntheticTruth.of(patient, Resolution.MEDIUM, List.of(FitPart.DIAPHRAGM), 1, 1);
        base = Scenario.defaults().with(SHEET_ALONE);
        body = patient.body(Resolution.LOW);
    }

    private static FitSetup setup(int evaluations, int threads) {
        List<FitParameter> parameters = List.of(
                FitParameter.of(Parameter.MUSCLE_ACTIVATION, base),
                FitParameter.of(Parameter.LEFT_OVER_RIGHT, base),
                FitParameter.of(Parameter.RIB_ROTATION, base));
        return new FitSetup(
                base,
                body,
                truth.targets(),
                parameters,
                false,
                "none",
                1,
                6,
                FitSetup.SIGMA,
                threads,
                evaluations,
                Double.POSITIVE_INFINITY,
                false);
    }

    @Test
    void findsTheBreathAndTheScenarioDoesItAgain() {
        FitResult result = Fit.run(setup(7, 2), folder.resolve("journal.csv"), (count, most, best, initial) -> {});
        assertThat(result.reproduced()).isTrue();
        assertThat(result.ratio()).isLessThan(0.35);
    }

    @Test
    void refusesATargetThatTheBodyDoesNotHave() {
        FitTarget liver = FitTarget.of(FitPart.LUNGS, truth.targets().get(0).surface());
        FitSetup wrong = FitSetup.of(base, body, List.of(liver), setup(1, 1).parameters(), 1);
        assertThatThrownBy(() -> Fit.run(wrong, folder.resolve("journal.csv"), (count, most, best, initial) -> {}))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no lungs that moves in the body");
        assertThat(folder.resolve("journal.csv")).doesNotExist();
    }
}
