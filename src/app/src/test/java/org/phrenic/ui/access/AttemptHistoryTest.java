package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

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

    @Test
    void aDistanceThatIsNoNumberIsNamedWithItsLine() throws IOException {
        AttemptHistory edited = history(ROW + "true,2\n" + ROW + "true,two\n");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> edited.learningCurve("Dome"))
                .withMessage(edited.file() + ": line 3, column 'distance_mm': found 'two', expected a number");
    }
}
