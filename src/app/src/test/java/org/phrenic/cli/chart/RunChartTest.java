package org.phrenic.cli.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Observation;

class RunChartTest {
    @TempDir
    Path folder;

    private Path table(List<String> columns) throws IOException {
        String head = String.join(",", columns) + "\n";
        String rows = IntStream.range(0, 100)
                .mapToObj(i -> i * 0.08 + "," + ("" + 10 * Math.sin(i * 0.2) + ",").repeat(columns.size() - 2) + "1\n")
                .collect(Collectors.joining());
        return Files.writeString(folder.resolve("observables.csv"), head + rows);
    }

    @Test
    void aPictureShowsTheCurvesInTheirColours() throws IOException {
        Path picture = folder.resolve("curves.png");
        RunChart.write(table(Observation.COLUMNS), "Quiet breath", picture);
        BufferedImage read = ImageIO.read(picture.toFile());
        int blue = 0;
        for (int y = 0; y < read.getHeight(); y++) {
            for (int x = 0; x < read.getWidth(); x++) {
                blue += (read.getRGB(x, y) & 0xffffff) == 0x0072b2 ? 1 : 0;
            }
        }
        assertThat(blue).isGreaterThan(500);
    }

    @Test
    void aMissingColumnIsNamedAndNothingIsWritten() throws IOException {
        Path observables = table(List.of("time_s", "dome_right_mm"));
        assertThatThrownBy(() -> RunChart.write(observables, "", folder.resolve("curves.png")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("dome_left_mm");
        assertThat(folder.resolve("curves.png")).doesNotExist();
    }
}
