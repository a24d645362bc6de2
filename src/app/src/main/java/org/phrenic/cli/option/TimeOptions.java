package org.phrenic.cli.option;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.export.GifMovieWriter;
import picocli.CommandLine.Option;

/** Options for picture times and movies. */
public final class TimeOptions {
    private static final int MAX_FRAMES = 100_000;
    private static final double MAX_MP4_FRAMES_PER_S = 240;
    private static final double DEFAULT_FPS = 20;

    @Option(
            names = "--at",
            paramLabel = "S[,S...]",
            description = "Simulated times of the pictures, s. Default: 0, the end of an expiration.")
    private String at;

    @Option(names = "--frames", paramLabel = "N", description = "So many pictures, spread evenly over the duration.")
    private String frames;

    @Option(
            names = "--movie",
            paramLabel = "FILE",
            description = "An MP4 (through ffmpeg, if it is on the path) or an animated GIF of the frames.")
    private Path movie;

    @Option(names = "--fps", paramLabel = "F", description = "Frames a second of the movie. Default: in real time.")
    private String fps;

    /** Checks all values that do not depend on the duration. */
    public void validate() {
        if (at != null && (frames != null || movie != null || fps != null)) {
            throw new BadInputException(
                    "--at " + at + ": found " + (movie != null ? "--movie" : frames != null ? "--frames" : "--fps")
                            + " too, expected single times or a sequence");
        }
        if (fps != null && frames == null && movie == null) {
            throw new BadInputException("--fps " + fps + ": found neither --frames nor --movie, expected one of them");
        }
        if (movie != null && !isGif() && !isMp4()) {
            throw new BadInputException("--movie " + movie + ": found an unknown ending, expected .mp4 or .gif");
        }
        if (frames != null) {
            OptionValues.integer("--frames", frames, 1, MAX_FRAMES);
        }
        if (fps != null) {
            OptionValues.number("--fps", fps, 0.1, mostFramesPerS());
        }
        singleTimes();
    }

    /** Requires that pictures at single times have file names of their own. */
    public void requireApart() {
        List<Double> times = DoubleStream.of(singleTimes()).boxed().toList();
        OptionValues.requireApart(
                "--at",
                times.stream().map(TimeOptions::label).toList(),
                times.stream().map(time -> time + " s").toList(),
                "times 0.001 s apart or more");
    }

    /** A time in a file name, such as {@code 1.500s}. */
    public static String label(double timeS) {
        return String.format(Locale.ROOT, "%.3fs", timeS);
    }

    private double[] singleTimes() {
        return at == null ? new double[] {0} : OptionValues.times("--at", at);
    }

    /** Movie file; null for none. */
    public Path movie() {
        return movie;
    }

    boolean isGif() {
        return ends(".gif");
    }

    public boolean isMp4() {
        return ends(".mp4");
    }

    private boolean ends(String ending) {
        return movie != null && movie.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }

    /** Whether the pictures form a numbered sequence. */
    public boolean isSequence() {
        return frames != null || movie != null;
    }

    /**
     * Picture times in ascending order, s.
     *
     * @throws BadInputException if a time is negative or after the end of the scenario
     */
    public double[] times(double totalS) {
        if (!isSequence()) {
            double[] times = singleTimes();
            OptionValues.requireWithin("--at", times, totalS);
            return times;
        }
        int count = frames == null
                ? (int) Math.max(1, Math.min(MAX_FRAMES, Math.round(totalS * frameRate())))
                : OptionValues.integer("--frames", frames, 1, MAX_FRAMES);
        return IntStream.range(0, count).mapToDouble(i -> i * totalS / count).toArray();
    }

    private double frameRate() {
        return fps == null ? DEFAULT_FPS : OptionValues.number("--fps", fps);
    }

    /** Frame rate of the movie, 1/s; by default the movie plays in real time. */
    public double framesPerS(int count, double totalS) {
        return fps != null ? frameRate() : Math.max(1, Math.min(mostFramesPerS(), count / totalS));
    }

    private double mostFramesPerS() {
        return isGif() ? GifMovieWriter.MAX_FRAMES_PER_S : MAX_MP4_FRAMES_PER_S;
    }
}
