package org.phrenic.cli.option;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import picocli.CommandLine.Option;

/** Options for the times of pictures. */
public class TimeOptions {
    static final int MAX_FRAMES = 100_000;

    @Option(
            names = "--at",
            paramLabel = "S[,S...]",
            description = "Simulated times of the pictures, s. Default: 0, the end of an expiration.")
    private String at;

    @Option(names = "--frames", paramLabel = "N", description = "So many pictures, spread evenly over the duration.")
    private String frames;

    /** Checks all values that do not depend on the duration. */
    public void validate() {
        if (frames != null) {
            requireNoTimes("--frames");
            OptionValues.integer("--frames", frames, 1, MAX_FRAMES);
        }
        singleTimes();
    }

    /** Refuses single times beside an option of a sequence. */
    final void requireNoTimes(String option) {
        if (at != null) {
            throw new BadInputException(
                    "--at " + at + ": found " + option + " too, expected single times or a sequence");
        }
    }

    /** Requires that pictures at single times have file names of their own. */
    public final void requireApart() {
        List<Double> times = DoubleStream.of(singleTimes()).boxed().toList();
        OptionValues.requireApart(
                "--at",
                times.stream().map(TimeOptions::label).toList(),
                times.stream().map(time -> time + " s").toList(),
                "times 0.001 s apart or more");
    }

    /** A time in a file name, such as {@code 1.500s}. */
    public static String label(double timeS) {
        return Numbers.format("%.3fs", timeS);
    }

    private double[] singleTimes() {
        return at == null ? new double[] {0} : OptionValues.times("--at", at);
    }

    /** Whether the pictures form a numbered sequence. */
    public boolean isSequence() {
        return frames != null;
    }

    /**
     * Picture times in ascending order, s.
     *
     * @throws BadInputException if a time is negative or after the end of the scenario
     */
    public final double[] times(double totalS) {
        if (!isSequence()) {
            double[] times = singleTimes();
            OptionValues.requireWithin("--at", times, totalS);
            return times;
        }
        int count = frames == null ? usualFrames(totalS) : OptionValues.integer("--frames", frames, 1, MAX_FRAMES);
        return IntStream.range(0, count).mapToDouble(i -> i * totalS / count).toArray();
    }

    /** Number of pictures of a sequence that states none. */
    int usualFrames(double totalS) {
        throw new IllegalStateException("found a sequence of " + totalS + " s without --frames");
    }
}
