package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.ShippedFileException;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.search.FitJournal;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.fit.search.ForeignJournalException;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.Attempts;
import org.phrenic.study.body.BodyCase;

/** Hidden settings of known breaths, and bodies whose breath cannot be computed. */
class KnownBreathTest {
    @TempDir
    private Path folder;

    /** 60 uniform draws leave less than a tenth of their interval empty at an end, but for one seed of 500. */
    @ParameterizedTest
    @CsvSource({"0, 0.4, 0.75", "1, 0.5, 1.3", "2, 0.8, 1.3", "3, 0.7, 1.4"})
    void successiveSeedsCoverTheRangeOfEverySetting(int place, double low, double high) {
        double[] drawn = IntStream.rangeClosed(1, 60)
                .mapToDouble(seed -> value(seed, 1, place))
                .sorted()
                .toArray();
        double tenth = (high - low) / 10;
        assertThat(drawn[0]).isBetween(low - 0.0005, low + tenth);
        assertThat(drawn[59]).isBetween(high - tenth, high + 0.0005);
    }

    @Test
    void aGentlerAttemptHasTheSameSettingsWithLessDrive() {
        assertThat(value(7, 0.4, 0)).isCloseTo(0.4 * value(7, 1, 0), within(0.001));
        assertThat(value(7, 0.4, 1)).isCloseTo(0.4 * value(7, 1, 1), within(0.001));
        assertThat(value(7, 0.4, 2)).isEqualTo(value(7, 1, 2));
        assertThat(value(7, 0.4, 3)).isEqualTo(value(7, 1, 3));
    }

    private KnownBreath fitted(Supplier<Thorax> body) {
        return KnownBreath.of(
                new BodyCase("random 1", "random", 1, body),
                Scenario.defaults(),
                1,
                new FitSearch.Settings(1, 1),
                1,
                folder,
                (count, most, best, initial) -> {});
    }

    private static Supplier<Thorax> failing(RuntimeException failure) {
        return () -> {
            throw failure;
        };
    }

    @Test
    void aMissingFileOfTheProgramEndsTheStudy() {
        assertThrows(
                ShippedFileException.class,
                () -> fitted(() -> {
                    throw new IllegalStateException(ShippedFile.text("thorax/none.yaml"));
                }));
    }

    private static Thorax diverging() {
        double[] at = {0, 0, 0};
        ParticleSystem node = new ParticleSystem(NodeLayout.morton(at), at, new double[] {1}, Workers.of(1));
        node.velocities()[0] = Double.NaN;
        new Stepper(IntegratorKind.VERLET.create(node), 0.1, StepPolicy.SUBSTEP).step();
        throw new AssertionError("a velocity that is no number diverges");
    }

    @Test
    void aBodyThatCannotBeComputedIsNamedWithItsReason() {
        assertThat(fitted(failing(new BadInputException("no lungs"))).failure()).isEqualTo("no lungs");
        assertThat(fitted(failing(new IllegalArgumentException("no step"))).failure())
                .isEqualTo("no step");
        KnownBreath diverged = fitted(KnownBreathTest::diverging);
        assertThat(diverged.result()).isEmpty();
        assertThat(diverged.failure()).contains("diverged");
    }

    /** The report of the other study stays. */
    @Test
    void aJournalOfAnotherStudyEndsTheStudy() throws IOException {
        Path journal = Files.writeString(folder.resolve("a.csv"), "evaluation,fit\n");
        Supplier<Thorax> body = () -> {
            throw assertThrows(ForeignJournalException.class, () -> new FitJournal(journal, "mark", "a", List.of()));
        };
        assertThatThrownBy(() -> fitted(body)).isInstanceOf(ForeignJournalException.class);
        Attempts<Thorax> attempts = new Attempts<>();
        assertThatThrownBy(() -> attempts.add("a", body)).isInstanceOf(ForeignJournalException.class);
    }

    private static double value(long seed, double drive, int place) {
        String setting = KnownBreath.hiddenSettings(seed, drive).get(place);
        return Double.parseDouble(setting.substring(setting.indexOf('=') + 1));
    }
}
