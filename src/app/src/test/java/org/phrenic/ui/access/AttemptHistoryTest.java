package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.Needle;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.file.BadInputException;
import org.phrenic.file.OutputException;
import org.phrenic.scenario.Scenario;

/** What is said of a file of attempts, which a user may edit. */
class AttemptHistoryTest {
    private static final String ROW = "2026-11-25T10:00,2026-11-25T10:01,Dome,none,";

    @TempDir
    Path folder;

    private AttemptHistory history(String rows) throws IOException {
        Path file = Files.writeString(folder.resolve("attempts.csv"), "session,time,exercise\n" + rows);
        return new AttemptHistory(file, "2026-11-25T10:00");
    }

    /** 2, 4 and 6 mm: mean 4, deviation 2. A row without a sample and one of another exercise do not count. */
    @Test
    void theCurveIsThatOfTheExerciseInFilesOfAnyVersion() throws IOException {
        String rows = ROW + "true,2.00,1,1,30,0\n" + ROW + "false,6.00\n" + ROW + "false,,,,30,0\n\n"
                + ROW.replace("Dome", "Other") + "true,x\n2026-11-26T10:00,,Dome,none,true,4.00,,,\n";
        assertThat(history(rows).learningCurve("Dome"))
                .isEqualTo("This exercise: 3 samples in 2 sessions, 2 hits, 4.0 \u00b1 2.0 mm off.");
        assertThat(history(rows).learningCurve("None of them")).isEmpty();
        assertThat(new AttemptHistory(folder.resolve("none.csv"), "").learningCurve("Dome"))
                .isEmpty();
    }

    /** The first five are 10 mm off, the last five 2 mm. */
    @Test
    void tenSamplesTellBothEnds() throws IOException {
        String rows = (ROW + "false,10\n").repeat(5) + (ROW + "true,2\n").repeat(5);
        assertThat(history(rows).learningCurve("Dome")).endsWith("; the first 5 10.0 mm, the last 5 2.0 mm.");
    }

    /** A row's hit, distance and errors are of one sample, the last; a learning curve counts the hits of those. */
    @Test
    void theRowOfAnAttemptIsThatOfItsLastSample() throws IOException {
        TargetingError hit = new TargetingError(3, 4, true, 0, OptionalDouble.empty());
        TargetingError miss = new TargetingError(-12, 5, false, 0, OptionalDouble.empty());
        AttemptHistory kept = new AttemptHistory(folder.resolve("kept.csv"), "2026-11-25T10:00");
        RehearsalPlan plan = RehearsalPlan.practice(
                Scenario.defaults(), SampledAttempts.TARGET, Needle.standard(), BreathCycle.PHASES);
        for (AttemptRecord record : List.of(
                SampledAttempts.record(hit, miss), SampledAttempts.record(miss, hit), SampledAttempts.record())) {
            kept.add(new Rehearsal(
                    plan, new BodySurfaces(List.of()), null, Optional.empty(), record, ProbeUse.NONE, List.of(), ""));
        }
        assertThat(Files.readAllLines(kept.file()))
                .extracting(row -> row.replaceFirst("^[^,]*,[^,]*,", ""))
                .satisfiesExactly(
                        header -> assertThat(header).startsWith("exercise,help,hit,distance_mm,axial_mm,lateral_mm,"),
                        row -> assertThat(row).startsWith("Practice,see-through,false,13.00,-12.00,5.00,"),
                        row -> assertThat(row).startsWith("Practice,see-through,true,5.00,3.00,4.00,"),
                        row -> assertThat(row).startsWith("Practice,see-through,,,,,"));
        assertThat(kept.learningCurve("Practice")).startsWith("This exercise: 2 samples in 1 session, 1 hit, 9.0");
    }

    /** A spreadsheet on Windows keeps others from the file that it shows. */
    @Test
    void attemptsThatCannotBeWrittenAreWrittenLaterInTheirOrder() throws IOException {
        AttemptHistory kept = new AttemptHistory(folder.resolve("kept.csv"), "2026-11-25T10:00");
        Path inTheWay = Files.createDirectory(kept.file());
        TargetingError first = new TargetingError(3, 4, true, 0, OptionalDouble.empty());
        TargetingError second = new TargetingError(-12, 5, false, 0, OptionalDouble.empty());
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> kept.add(SampledAttempts.rehearsal(first)))
                .withMessageStartingWith(kept.file().toString());
        assertThat(kept.waiting()).isEqualTo(1);
        Files.delete(inTheWay);
        kept.add(SampledAttempts.rehearsal(second));
        assertThat(kept.waiting()).isZero();
        assertThat(Files.readAllLines(kept.file()))
                .satisfiesExactly(
                        header -> assertThat(header).startsWith("session,time,exercise,"),
                        row -> assertThat(row).contains(",true,5.00,3.00,4.00,"),
                        row -> assertThat(row).contains(",false,13.00,-12.00,5.00,"));
        kept.writeWaiting();
        assertThat(Files.readAllLines(kept.file())).hasSize(3);
    }

    /** At the end of the window its user closes the spreadsheet after the second question. */
    @Test
    void whatWaitsAtTheEndIsWrittenOnceItsUserHasClosedTheFile() throws IOException {
        AttemptHistory kept = new AttemptHistory(folder.resolve("kept.csv"), "2026-11-25T10:00");
        Path inTheWay = Files.createDirectory(kept.file());
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() ->
                        kept.add(SampledAttempts.rehearsal(new TargetingError(3, 4, true, 0, OptionalDouble.empty()))));
        kept.writeWaiting(reason -> false);
        assertThat(kept.waiting()).isEqualTo(1);
        List<String> asked = new ArrayList<>();
        kept.writeWaiting(reason -> {
            asked.add(reason);
            if (asked.size() == 2) {
                inTheWay.toFile().delete();
            }
            return true;
        });
        assertThat(asked)
                .hasSize(2)
                .allMatch(reason -> reason.startsWith(kept.file().toString()));
        assertThat(kept.waiting()).isZero();
        assertThat(Files.readAllLines(kept.file())).hasSize(2);
    }

    @Test
    void aDistanceThatIsNoNumberIsNamedWithItsLine() throws IOException {
        AttemptHistory edited = history(ROW + "true,2\n" + ROW + "true,two\n");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> edited.learningCurve("Dome"))
                .withMessage(edited.file() + ": line 3, column 'distance_mm': found 'two', expected a number");
    }

    /** A table's reader takes the form of all times from the first. */
    @Test
    void aTimeOfNoSecondsIsWrittenWithThem() {
        assertThat(AttemptHistory.text(LocalDateTime.of(2026, 11, 29, 6, 5, 0, 999)))
                .isEqualTo("2026-11-29T06:05:00");
    }

    private static final String COLUMNS =
            "session,time,exercise,help,hit,distance_mm,axial_mm,lateral_mm,time_s,no_go_s,"
                    + "probe_s,tip_out_of_beam_s,needle_in_beam_mm,needle_in_beam_share,aims_by_program,"
                    + "greatest_force_n,capsule_push_mm,side_load_n,bending_mm";

    @Test
    void aColumnOfNotesAtTheRightIsKept() throws IOException {
        Path file = folder.resolve("notes.csv");
        AttemptHistory kept = new AttemptHistory(file, "2026-11-25T10:00");
        Rehearsal first = SampledAttempts.rehearsal(new TargetingError(3, 4, true, 0, OptionalDouble.empty()));
        kept.add(first);
        List<String> rows = Files.readAllLines(file);
        Files.writeString(file, rows.get(0) + ",notes\n" + rows.get(1) + ",\"steep, slow\"\n");
        kept.add(SampledAttempts.rehearsal(new TargetingError(6, 8, false, 0, OptionalDouble.empty())));
        assertThat(Files.readAllLines(file))
                .hasSize(3)
                .startsWith(COLUMNS + ",notes", rows.get(1) + ",\"steep, slow\"");
        assertThat(kept.learningCurve(first.plan().title()))
                .startsWith("This exercise: 2 samples in 1 session, 1 hit, 7.5");
    }

    /**
     * Text with commas and breaks in its cells, a column without a heading, and two of one name, as spreadsheets save.
     */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"notes, steep\"\n%s,slow",
                "notes\n%s,\"first\nsecond, third\"",
                "notes; remarks\n%s,slow",
                "\n%s,slow",
                "notes,notes\n%s,slow,steep",
                "notes\n%s,slow,steep"
            })
    void whatStandsBehindTheColumnsMayBeAnyText(String behind) throws IOException {
        Path file = folder.resolve("notes.csv");
        AttemptHistory kept = new AttemptHistory(file, "2026-11-25T10:00");
        Rehearsal first = SampledAttempts.rehearsal(new TargetingError(3, 4, true, 0, OptionalDouble.empty()));
        kept.add(first);
        String edited =
                COLUMNS + "," + behind.formatted(Files.readAllLines(file).get(1)) + "\n";
        Files.writeString(file, edited);
        kept.add(SampledAttempts.rehearsal(new TargetingError(6, 8, false, 0, OptionalDouble.empty())));
        assertThat(file).content().startsWith(edited);
        assertThat(kept.learningCurve(first.plan().title()))
                .startsWith("This exercise: 2 samples in 1 session, 1 hit, 7.5");
    }

    /** Under the program's own header their cells would be taken for others, and what stood there be lost. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    session,time,exercise,hit,distance_mm | 'hit' as column 4 of a table with commas, expected 'help'
                    session,time,exercise,help,distance_mm,hit | 'distance_mm' as column 5 of a table with commas, expected 'hit'
                    2026-11-25T10:00,2026-11-25T10:01,Dome | '2026-11-25T10:00' as column 1 of a table with commas, expected 'session'
                    session;time | 'session;time' as column 1 of a table with commas, expected 'session'
                    """)
    void aFileOfOtherColumnsIsLeftAsItIsAndTheAttemptWaits(String header, String found) throws IOException {
        Path file = Files.writeString(folder.resolve("attempts.csv"), header + "\n" + ROW + "true,2\n");
        AttemptHistory edited = new AttemptHistory(file, "2026-11-25T10:00");
        TargetingError sample = new TargetingError(3, 4, true, 0, OptionalDouble.empty());
        for (Runnable use : List.<Runnable>of(
                () -> edited.add(SampledAttempts.rehearsal(sample)), () -> edited.learningCurve("Dome"))) {
            assertThatExceptionOfType(BadInputException.class)
                    .isThrownBy(use::run)
                    .withMessage(file + ": line 1: found " + found);
        }
        assertThat(edited.waiting()).isEqualTo(1);
        assertThat(Files.readAllLines(file)).containsExactly(header, ROW + "true,2");
    }

    @Test
    void aFileThatIsNotUtf8IsToldAsSuch() throws IOException {
        Path file = Files.writeString(folder.resolve("ansi.csv"), COLUMNS + "\n\u00e4", StandardCharsets.ISO_8859_1);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> new AttemptHistory(file, "").learningCurve("Dome"))
                .withMessage(file + ": found bytes that are not UTF-8, expected a table in UTF-8");
    }
}
