package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.phrenic.breathing.pattern.BreathingPatternContract.at;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingTrace;
import org.phrenic.breathing.BreathingTraceReader;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;

class TracePatternTest {
    private static final BreathingParameters DEPTH = new BreathingParameters(15, 0.4, 0.1, 0.26, 0.06, 1.0 / 6, 0.5);

    @TempDir
    Path folder;

    /** Breaths of 5 s and 3 mm along (0, 0.6, 0.8), as a camera writes them with a comma for the point. */
    @Test
    void markersWithDecimalCommasAndABogusLastRowAreRead() throws IOException {
        BreathingTrace trace = BreathingTraceReader.read(write(markers(300) + "0;0;0;0;0\n"));
        assertThat(trace.timeS()).hasSize(300);
        assertThat(trace.timeS()[299]).isCloseTo(29.9, within(1e-12));
        double range = 0;
        for (double value : trace.amplitude()) {
            range = Math.max(range, value - trace.amplitude()[0]);
        }
        // end-expiration is the first sample, so the sign must be right too; positions are written to 0.001 mm
        assertThat(range).isCloseTo(3, within(0.01));
    }

    @Test
    void aMarkerThatDoesNotMoveIsRefused() throws IOException {
        Path still = write(markers(30).replaceAll(";-488;.*", ";-488;1,7;64,3"));
        assertThatThrownBy(() -> BreathingTraceReader.read(still))
                .hasMessageContaining("found no motion of a marker, expected rows of positions");
    }

    /** Some cameras stamp a frame now and then in another unit. */
    @Test
    void singleRowsWithATimeThatDoesNotRiseAreLeftOut() throws IOException {
        BreathingTrace trace = BreathingTraceReader.read(write(markers(300).replace(";20000;", ";40;")));
        assertThat(trace.dropped()).isEqualTo(1);
        assertThat(trace.timeS()).hasSize(299);
    }

    @Test
    void aTraceIsBreathedAtItsOwnRate() throws IOException {
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(write(markers(300))), DEPTH, true);
        BreathingPatternContract.check(pattern, 62);
        assertThat(pattern.breaths()).isEqualTo(6);
        double deepest = 0;
        for (double t = 0; t < 30; t += 0.01) {
            deepest = Math.max(deepest, at(pattern, t).activation);
        }
        // 1 at the 95th percentile, the peak a little above: the wave stays within 10 % of it for some per cent of the
        // time
        assertThat(deepest).isBetween(0.26, 1.15 * 0.26);
        BreathState again = at(pattern, pattern.periodS() + 7);
        assertThat(again.activation).isCloseTo(at(pattern, 7).activation, within(1e-12));
        assertThat(again.breath).isEqualTo(6 + at(pattern, 7).breath);
    }

    @Test
    void whatWasReadOfATraceIsSaidWithItsScaleAndPeriod() throws IOException {
        Path file = write(noisy());
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(file), DEPTH, true);
        // It begins and ends at a minimum of the vibration, each less than 0.33 s inside the 30 s.
        assertThat(pattern.description())
                .contains(file.getFileName() + ": column amplitude", "6 breaths", "again from the first")
                .containsPattern("depth 0 at -?0\\.0\\d+, 1 at (0\\.9|1\\.0)\\d+ \\(5th and 95th percentile\\)")
                .containsPattern("(4\\.9|5\\.0) s each");
        TracePattern markers = new TracePattern(BreathingTraceReader.read(write(markers(300))), DEPTH, true);
        assertThat(markers.description()).contains("first principal component of columns x, y, z", "5.0 s each");
    }

    /** The lowest sample before the first breath is at 1 s. */
    @Test
    void whereInTheRecordingTheBreathBeginsIsSaid() throws IOException {
        TracePattern pattern =
                new TracePattern(BreathingTraceReader.read(write(TraceSamples.fromOneSecondOn())), DEPTH, true);
        assertThat(pattern.startS()).isEqualTo(1);
        assertThat(pattern.description()).contains("2 breaths in 8.0 s from 1.00 s of the recording on, 4.0 s each");
    }

    /** Recorders are started and stopped at any phase; a breath of which a part is missing is no breath. */
    @Test
    void aRecordingThatBeginsAndEndsWithinABreathIsCutToItsWholeBreaths() throws IOException {
        TracePattern pattern = new TracePattern(
                BreathingTraceReader.read(write(TraceSamples.fromHalfwayUpToHalfwayDown())), DEPTH, true);
        assertThat(pattern.description()).contains("3 breaths in 12.0 s from 3.00 s of the recording on, 4.0 s each");
        BreathingPatternContract.check(pattern, 26);
    }

    /** Two samples a second. */
    @Test
    void aRecordingOfFewSamplesIsCutToItsWholeBreathsToo() throws IOException {
        String[] rows = TraceSamples.fromHalfwayUpToHalfwayDown().split("\n", -1);
        StringBuilder few = new StringBuilder(rows[0]).append('\n');
        for (int i = 1; i < rows.length - 1; i += 5) {
            few.append(rows[i]).append('\n');
        }
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(write(few.toString())), DEPTH, true);
        assertThat(pattern.description()).contains("3 breaths in 12.0 s from 3.00 s of the recording on");
    }

    /** Something must be breathed: of two parts of breaths the second is taken. */
    @Test
    void aRecordingWithoutAWholeBreathKeepsAPart() throws IOException {
        String[] rows = TraceSamples.fromHalfwayUpToHalfwayDown().split("\n", -1);
        String sixSeconds = String.join("\n", Arrays.copyOf(rows, 62)) + "\n";
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(write(sixSeconds)), DEPTH, true);
        assertThat(pattern.description()).contains("1 breath in 3.0 s from 3.00 s of the recording on");
    }

    /** Noise turns the slope many times a breath; a breath still is one inspiration and one expiration. */
    @Test
    void aNoisyTraceHasOneInspirationABreath() throws IOException {
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(write(noisy())), DEPTH, true);
        int inspirations = 0;
        RespiratoryPhase before = RespiratoryPhase.PAUSE;
        for (double t = 0.1; t < pattern.periodS() - 0.1; t += 0.02) {
            RespiratoryPhase now = at(pattern, t).respiratoryPhase;
            if (now == RespiratoryPhase.INSPIRATION && before != now && before != RespiratoryPhase.PAUSE) {
                inspirations++;
            }
            before = now == RespiratoryPhase.PAUSE ? before : now;
        }
        // The first begins at the start of the recording and follows no expiration.
        assertThat(inspirations).isEqualTo(5);
    }

    /** Breaths of 5 s with a vibration of 3 Hz, 4 % of their depth. */
    private static String noisy() {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= 600; i++) {
            double t = i / 20.0;
            double breath = (1 - Math.cos(2 * Math.PI * t / 5)) / 2 + 0.04 * Math.sin(6 * Math.PI * t);
            csv.append(t).append(',').append(breath).append('\n');
        }
        return csv.toString();
    }

    @Test
    void withoutLoopingItRestsAtTheEnd() throws IOException {
        TracePattern pattern = new TracePattern(BreathingTraceReader.read(write(markers(300))), DEPTH, false);
        BreathState over = at(pattern, 100);
        assertThat(over.activation).isZero();
        assertThat(over.ribTurnRate).isZero();
        assertThat(over.respiratoryPhase).isEqualTo(RespiratoryPhase.PAUSE);
        BreathingPatternContract.check(pattern, 35);
    }

    @Test
    void badTracesAreRefusedInOneSentence() throws IOException {
        refused("a,b\n1,2\n", ": line 1: found columns 'a b', expected 'Frame;Timestamp;x;y;z' or 'time_s,amplitude'");
        refused("time_s,amplitude\n0,1\n1,x\n", ": line 3, column 'amplitude': found 'x', expected a number");
        refused("time_s,amplitude\n0,1\n1\n", ": line 3: found 1 cells, expected 2 as in the header");
        refused(
                "time_s,amplitude\n0,1\n1,2\n0.5,2\n",
                ": line 4, column 'time_s': found time 0.5, expected more than the 1.0 before it (1 of 3 rows are out"
                        + " of order)");
        refused("time_s,amplitude\n0,1\n", ": 1 times and 1 values, expected as many of both and at least 8");
        refused("", ": found an empty file, expected content");
        refused(
                "time_s,amplitude\n",
                ": found no rows, expected 'Frame;Timestamp;x;y;z' or 'time_s,amplitude' and samples");
        Path flat = write("time_s,amplitude\n0,1\n1,1\n2,1\n3,1\n4,1\n5,1\n6,1\n7,1\n");
        BreathingTrace trace = BreathingTraceReader.read(flat);
        assertThatThrownBy(() -> new TracePattern(trace, DEPTH, true))
                .hasMessage(flat + ": the signal stays at 1.0, expected breathing");
        Path binary = folder.resolve("binary.csv");
        Files.write(binary, new byte[] {(byte) 0xff, (byte) 0xfe, 0, 1});
        assertThatThrownBy(() -> BreathingTraceReader.read(binary))
                .hasMessage(binary + ": found bytes that are not UTF-8, expected a CSV file of recorded breathing");
    }

    /**
     * The breaths counted in the recordings of people must last what the strongest period of the spectrum says, which
     * was found by other means; a deep or missed breath here and there leaves a tenth between them.
     */
    @Test
    void recordingsOfPeopleAreBreathed() throws IOException {
        Path recordings = Path.of("..", "shared", "breathing", "skin-markers");
        Assumptions.assumeTrue(Files.isDirectory(recordings), "no " + recordings + " beside the project");
        int found = 0;
        for (String line : Files.readAllLines(recordings.resolve("stats.csv"))) {
            Path file = recordings.resolve(line.substring(0, line.indexOf(',')));
            if (!Files.exists(file)) {
                continue;
            }
            found++;
            double dominantS = Double.parseDouble(line.split(",")[8]);
            BreathingTrace trace = BreathingTraceReader.read(file);
            TracePattern pattern = new TracePattern(trace, DEPTH, true);
            assertThat(trace.dropped()).as(file.toString()).isLessThanOrEqualTo(3);
            assertThat(pattern.periodS() / pattern.breaths())
                    .as(file.toString())
                    .isCloseTo(dominantS, within(0.1 * dominantS));
            BreathingPatternContract.check(pattern, 20);
        }
        assertThat(found).isGreaterThan(10);
    }

    private Path write(String text) throws IOException {
        Path file = folder.resolve("trace.csv");
        Files.writeString(file, text);
        return file;
    }

    private void refused(String text, String message) throws IOException {
        Path file = write(text);
        assertThatThrownBy(() -> BreathingTraceReader.read(file))
                .isInstanceOf(BadInputException.class)
                .hasMessage(file + message);
    }

    /** A cosine squared, so that it dwells at end-expiration as people do; 0 to 3. */
    private static double breath(double timeS) {
        double half = Math.sin(Math.PI * timeS / 5);
        return 3 * half * half * half * half;
    }

    private static String markers(int count) {
        StringBuilder csv = new StringBuilder("\"Frame\";\"Timestamp\";\"x\";\"y\";\"z\"\n");
        for (int i = 0; i < count; i++) {
            double depth = breath(i / 10.0);
            csv.append(6 * i).append(';').append(100 * i).append(";-488;");
            csv.append(comma(1.7 + 0.6 * depth))
                    .append(';')
                    .append(comma(64.3 + 0.8 * depth))
                    .append('\n');
        }
        return csv.toString();
    }

    private static String comma(double value) {
        return String.valueOf(Math.round(1000 * value) / 1000.0).replace('.', ',');
    }
}
