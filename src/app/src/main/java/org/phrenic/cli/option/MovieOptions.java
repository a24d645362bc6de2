package org.phrenic.cli.option;

import java.nio.file.Path;
import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.export.GifMovieWriter;
import picocli.CommandLine.Option;

/** Options for picture times and movies. */
public final class MovieOptions extends TimeOptions {
    private static final double MAX_MP4_FRAMES_PER_S = 240;
    private static final double DEFAULT_FPS = 20;

    @Option(
            names = "--movie",
            paramLabel = "FILE",
            description = "An MP4 (through ffmpeg, if it is on the path) or an animated GIF of the frames.")
    private Path movie;

    @Option(names = "--fps", paramLabel = "F", description = "Frames a second of the movie. Default: in real time.")
    private String fps;

    @Override
    public void validate() {
        if (movie != null) {
            requireNoTimes("--movie");
        }
        if (fps != null && movie == null) {
            throw new BadInputException("--fps " + fps + ": found no --movie, expected a movie to play at this rate");
        }
        if (movie != null && !isGif() && !isMp4()) {
            throw new BadInputException("--movie " + movie + ": found an unknown ending, expected .mp4 or .gif");
        }
        if (fps != null) {
            OptionValues.number("--fps", fps, 0.1, mostFramesPerS());
        }
        super.validate();
    }

    /** Movie file; null for none. */
    public Path movie() {
        return movie;
    }

    /** Makes an animated GIF beside the place of an MP4, with no more frames a second than a GIF can play. */
    public void useGif() {
        movie = movie.resolveSibling(movie.getFileName().toString().replaceFirst("(?i)mp4$", "gif"));
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

    @Override
    public boolean isSequence() {
        return movie != null || super.isSequence();
    }

    @Override
    int usualFrames(double totalS) {
        return (int) Math.max(1, Math.min(MAX_FRAMES, Math.round(totalS * frameRate())));
    }

    private double frameRate() {
        return fps == null ? DEFAULT_FPS : Math.min(OptionValues.number("--fps", fps), mostFramesPerS());
    }

    /** Frame rate of the movie, 1/s; by default the movie plays in real time. */
    public double framesPerS(int count, double totalS) {
        return fps != null ? frameRate() : Math.max(1, Math.min(mostFramesPerS(), count / totalS));
    }

    private double mostFramesPerS() {
        return isGif() ? GifMovieWriter.MAX_FRAMES_PER_S : MAX_MP4_FRAMES_PER_S;
    }
}
