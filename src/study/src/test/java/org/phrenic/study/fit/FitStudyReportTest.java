package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.SyntheticPatient;
import org.phrenic.fit.SyntheticStudy;
import org.phrenic.scenario.Scenario;

/** A fit whose scenario gives another state is a failed check of every study of fits. */
class FitStudyReportTest {
    private static FitResult fit(boolean reproduced) {
        return new FitResult(
                null,
                new double[0],
                1,
                2,
                2,
                List.of(),
                Optional.empty(),
                List.of(),
                Map.of(),
                Scenario.defaults(),
                reproduced,
                null);
    }

    private static FitStudyReport ofPatient(boolean whole, boolean even, boolean odd) {
        return new FitStudyReport(List.of(new PatientFit("a", fit(whole), fit(even), fit(odd))), List.of(), List.of());
    }

    private static FitStudyReport ofKnown(Optional<FitResult> result) {
        return new FitStudyReport(List.of(), List.of(new KnownBreath("a", List.of(), result, "")), List.of());
    }

    @Test
    void everyFitOfAStudyIsReproduced() {
        assertThat(ofPatient(true, true, true).passes()).isTrue();
        for (FitStudyReport other :
                List.of(ofPatient(false, true, true), ofPatient(true, false, true), ofPatient(true, true, false))) {
            assertThat(other.passes()).isFalse();
            assertThat(other.summary()).endsWith(", 1 fits whose scenario gives another state");
        }
        assertThat(ofKnown(Optional.of(fit(true))).passes()).isTrue();
        assertThat(ofKnown(Optional.of(fit(false))).passes()).isFalse();
        assertThat(ofKnown(Optional.empty()).passes()).isFalse();
        assertThat(new FitStudyReport(List.of(), List.of(), List.of("b: no scan")).passes())
                .isFalse();
    }

    @Test
    void everyFitOfASyntheticPatientIsReproduced() {
        SyntheticPatient patient = SyntheticPatient.five().get(0);
        SyntheticStudy.Case good = new SyntheticStudy.Case(patient, null, fit(true));
        assertThat(new SyntheticStudy(List.of(good)).failure()).isEmpty();
        assertThat(new SyntheticStudy(List.of(good, new SyntheticStudy.Case(patient, null, fit(false)))).failure())
                .contains("Scenarios that were run and do NOT give the fitted state: " + patient.name() + ".");
    }
}
