package org.phrenic.cli.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
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

    private static final int BLUE = 0x0072b2;
    private static final int ORANGE = 0xd55e00;
    private static final int GREEN = 0x009e73;

    /** A quarter of the width of a picture, pixels: a line of a legend is shorter, and a level curve longer. */
    private static final int LINE = 300;

    /** Rows in which each column has its own number, that of its place. */
    private Path table(List<String> columns) throws IOException {
        String head = String.join(",", columns) + "\n";
        String places =
                IntStream.range(1, columns.size()).mapToObj(c -> "," + c).collect(Collectors.joining());
        String rows =
                IntStream.range(0, 100).mapToObj(i -> i * 0.08 + places + "\n").collect(Collectors.joining());
        return Files.writeString(folder.resolve("observables.csv"), head + rows);
    }

    /** From the top: domes, lung volume, chest wall and liver; the later a column, the higher its line. */
    @Test
    void aPictureShowsTheCurvesOfEveryPanelInTheirColours() throws IOException {
        Path picture = folder.resolve("curves.png");
        RunChart.write(table(Observation.COLUMNS), "Quiet breath", picture);
        assertThat(lines(ImageIO.read(picture.toFile())))
                .containsExactly(GREEN, ORANGE, BLUE, BLUE, GREEN, ORANGE, BLUE, GREEN, ORANGE, BLUE);
    }

    /** Colours of the level lines of a picture, from the top. */
    private static List<Integer> lines(BufferedImage picture) {
        List<Integer> lines = new ArrayList<>();
        int above = 0;
        for (int row = 0; row < picture.getHeight(); row++) {
            int y = row;
            int here = IntStream.of(BLUE, ORANGE, GREEN)
                    .filter(colour -> IntStream.range(0, picture.getWidth())
                                    .filter(x -> (picture.getRGB(x, y) & 0xffffff) == colour)
                                    .count()
                            > LINE)
                    .findFirst()
                    .orElse(0);
            if (here != 0 && here != above) {
                lines.add(here);
            }
            above = here;
        }
        return lines;
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
