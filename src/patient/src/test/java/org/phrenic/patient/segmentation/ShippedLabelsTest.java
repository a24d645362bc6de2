package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * The table of TotalSegmentator's labels. Sides and levels are told by both names of a row; the numbers are those of
 * the class list of its version 2 ("total": rib_left_1 is 92, rib_right_1 is 104, vertebrae_L5 is 27).
 */
class ShippedLabelsTest {
    private static final Pattern RIB = Pattern.compile("(\\d+),rib_(left|right)_(\\d+),(\\S+)");

    private static List<String> rows() throws IOException {
        return Files.readAllLines(Path.of("data", "labels", "totalsegmentator.csv"));
    }

    @Test
    void ribsKeepTheirSidesAndLevels() throws IOException {
        int ribs = 0;
        for (String row : rows()) {
            Matcher rib = RIB.matcher(row);
            if (rib.matches()) {
                int level = Integer.parseInt(rib.group(3));
                boolean left = rib.group(2).equals("left");
                assertThat(Integer.parseInt(rib.group(1))).as(row).isEqualTo((left ? 91 : 103) + level);
                assertThat(rib.group(4)).as(row).isEqualTo(String.format("rib_%02d_%s", level, left ? "L" : "R"));
                ribs++;
            }
        }
        assertThat(ribs).isEqualTo(24);
    }

    @Test
    void whatIsNamedLeftOrRightBecomesAStructureOfThatSide() throws IOException {
        for (String row : rows()) {
            String[] cells = row.split(",");
            boolean kept = cells.length > 2 && (cells[2].endsWith("_L") || cells[2].endsWith("_R"));
            if (kept && !cells[1].startsWith("vertebrae")) {
                assertThat(cells[1]).as(row).contains(cells[2].endsWith("_L") ? "left" : "right");
            }
        }
    }
}
