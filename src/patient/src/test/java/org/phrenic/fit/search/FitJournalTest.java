package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.OutputException;
import org.phrenic.model.material.Muscle;

/** Evaluations that a fit goes on from are those of the same fit and of the same build of the program. */
class FitJournalTest {
    private static final List<FitParameter> PARAMETERS =
            List.of(new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, 0.8, 0.6));

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("journal.csv");
    }

    private FitJournal journal(String program) {
        return new FitJournal(file, "mark", program, PARAMETERS);
    }

    private static Evaluation evaluation(double value, float... shape) {
        return new Evaluation(new double[] {0.6}, value, shape);
    }

    @Test
    void refusesTheJournalOfAnotherBuild() throws IOException {
        journal("phrenic 1 build a").add(0, evaluation(12), false);
        assertThat(journal("phrenic 1 build a").known(0).value()).isEqualTo(12);
        assertThatThrownBy(() -> journal("phrenic 1 build b"))
                .isInstanceOf(ForeignJournalException.class)
                .hasMessage(
                        file + ": found evaluations of another build of the program (phrenic 1 build a),"
                                + " expected those of this one (phrenic 1 build b); another folder begins anew, or this one without the file and its .shapes");

        Files.writeString(file, "evaluation,fit,distance_mm,drive,failure,muscle_activation\n0,mark,12.0,1.0,,0.6\n");
        assertThatThrownBy(() -> journal("phrenic 1 build b"))
                .isInstanceOf(ForeignJournalException.class)
                .hasMessageContaining("another build of the program (an earlier version), expected");
    }

    /** Where the disk is full for a moment, half of a line is written, and other breaths go on. */
    @Test
    void aLineThatIsWrittenInPartLeavesTheOthersReadable() throws IOException {
        FitJournal journal = journal("a");
        journal.add(0, evaluation(12), false);
        Files.writeString(file, "1,mark,a,11.3", StandardOpenOption.APPEND);
        journal.add(2, evaluation(10), false);
        FitJournal read = journal("a");
        assertThat(read.known(0).value()).isEqualTo(12);
        assertThat(read.known(1)).isNull();
        assertThat(read.known(2).value()).isEqualTo(10);
    }

    /** Two fits may write into one folder where the file system has no locks. */
    @Test
    void linesOfAnotherProgramAreKept() throws IOException {
        FitJournal journal = journal("a");
        journal.add(0, evaluation(12), false);
        String lines = Files.readString(file);
        List<String> others = List.of(
                lines + lines.lines().skip(1).findFirst().orElseThrow().replace("0,mark", "1,mark") + "\n",
                lines.replace("12.0", "12.25") + "1,ma",
                lines.substring(0, lines.indexOf('\n') + 1));
        for (String other : others) {
            Files.writeString(file, other);
            assertThatThrownBy(() -> journal.add(2, evaluation(10), false))
                    .isInstanceOf(OutputException.class)
                    .hasMessageStartingWith(file + ": found other lines than this fit has written");
            assertThat(file).hasContent(other);
        }
    }

    @Test
    void aJournalThatIsDeletedIsNotMadeAnewWithinAFit() throws IOException {
        FitJournal journal = journal("a");
        journal.add(0, evaluation(12), false);
        Files.delete(file);
        assertThatThrownBy(() -> journal.add(1, evaluation(11), false))
                .isInstanceOf(OutputException.class)
                .hasMessageStartingWith(file.toString());
        assertThat(file).doesNotExist();
    }

    /** The journal alone was deleted. */
    @Test
    void aShapeIsThatOfTheEvaluationInTheJournal() throws IOException {
        FitJournal first = journal("a");
        first.add(0, evaluation(12, 1, 2), true);
        first.add(1, evaluation(11, 3, 4), true);
        Files.delete(file);
        journal("a").add(0, evaluation(13, 5, 6), true);
        assertThat(journal("a").shape(0)).containsExactly(5, 6);
        assertThat(journal("a").shape(1)).containsExactly(3, 4);

        Files.delete(file);
        assertThat(journal("b").shape(0)).isNull();
        journal("b").add(1, evaluation(13, 7, 8), true);
        assertThat(journal("b").shape(0)).isNull();
        assertThat(journal("b").shape(1)).containsExactly(7, 8);
    }
}
