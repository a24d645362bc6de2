package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.scene.export.MovieWriter;
import org.phrenic.scene.export.PngFile;

/** One way of seeing a scene that is simulated. Times must be requested in ascending order. */
public final class Shot {
    private final DoubleFunction<BufferedImage> at;

    /** @param at makes the picture of a time, s */
    Shot(DoubleFunction<BufferedImage> at) {
        this.at = at;
    }

    /** Simulates up to a time and writes a picture. */
    public void writePicture(Path file, double timeS) {
        PngFile.write(file, at.apply(timeS));
    }

    /**
     * Simulates through the given times and writes a movie with one frame per time.
     *
     * @param single picture file for each frame index; empty for no picture files
     */
    public void writeMovie(
            Path file, MovieWriter kind, double framesPerS, double[] timesS, Optional<IntFunction<Path>> single) {
        Stream<BufferedImage> frames = IntStream.range(0, timesS.length).mapToObj(i -> {
            BufferedImage picture = at.apply(timesS[i]);
            single.ifPresent(name -> PngFile.write(name.apply(i), picture));
            return picture;
        });
        kind.write(file, framesPerS, frames.iterator());
    }
}
