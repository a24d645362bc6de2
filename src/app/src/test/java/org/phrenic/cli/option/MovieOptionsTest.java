package org.phrenic.cli.option;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** How fast a movie plays. */
class MovieOptionsTest {
    private static MovieOptions options(String... arguments) {
        MovieOptions options = CommandLine.populateCommand(new MovieOptions(), arguments);
        options.validate();
        return options;
    }

    private static double playedS(MovieOptions options, double simulatedS) {
        int frames = options.times(simulatedS).length;
        return frames / options.framesPerS(frames, simulatedS);
    }

    /** A GIF plays fewer frames a second than an MP4, not the same frames more slowly. */
    @ParameterizedTest
    @ValueSource(strings = {"100", "50", "20"})
    void aMovieThatBecomesAGifPlaysInTheTimeAskedFor(String fps) {
        MovieOptions options = options("--movie", "clips/breath.mp4", "--fps", fps);
        assertThat(playedS(options, 4)).isEqualTo(4);
        options.useGif();
        assertThat(options.movie()).isEqualTo(Path.of("clips", "breath.gif"));
        assertThat(options.framesPerS(1, 4)).isLessThanOrEqualTo(50);
        assertThat(playedS(options, 4)).isEqualTo(4);
    }

    @Test
    void anMp4KeepsItsFrames() {
        assertThat(options("--movie", "breath.mp4", "--fps", "100").times(4)).hasSize(400);
    }
}
