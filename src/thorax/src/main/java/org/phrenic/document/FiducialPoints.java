package org.phrenic.document;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * Reader of fiducials of 3D Slicer ({@code .fcsv}) as a table with the columns name, x_mm, y_mm, z_mm in LPS. Lines
 * that begin with # name the axes and the columns; without axes they are RAS, as in the first versions of the format.
 * Rows may have more cells than the line of columns names; those of Slicer 5 say behind the last column whether the
 * position is defined. Points without a defined position are left out.
 */
final class FiducialPoints {
    private static final String ENDING = ".fcsv";
    private static final String COLUMNS = "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID";

    /** The last column of Slicer, behind which the status of a position follows where a row has more cells. */
    private static final String LAST_COLUMN = "associatedNodeID";
    /** Status of a position that is not set, previewed or missing; 2 is defined. */
    private static final Set<String> UNDEFINED = Set.of("0", "1", "3");

    private final String file;
    private final List<String[]> rows = new ArrayList<>();
    private final List<Long> lines = new ArrayList<>();
    private List<String> columns = Arrays.asList(COLUMNS.split(",", -1));
    private double sign = -1;

    private FiducialPoints(String file) {
        this.file = file;
    }

    /** Whether the name of a file is that of fiducials. */
    static boolean isFiducials(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith(ENDING);
    }

    /** @throws BadInputException if the axes are neither RAS nor LPS, or a row has no three finite numbers */
    static CsvTable read(Path path) {
        FiducialPoints points = new FiducialPoints(path.toString());
        long number = 0;
        for (String line : TextFile.read(path, "fiducials of 3D Slicer").lines().toList()) {
            number++;
            if (line.startsWith("#")) {
                points.readComment(number, line.substring(1));
            } else if (!line.isBlank()) {
                points.readPoint(number, line);
            }
        }
        return CsvTable.of(points.file, MarkupPoints.COLUMNS, points.rows, points.lines);
    }

    private void readComment(long line, String comment) {
        String[] parts = comment.split("=", 2);
        String value = parts.length < 2 ? "" : parts[1].strip();
        switch (parts[0].strip().toLowerCase(Locale.ROOT)) {
            // Old files number the systems: 0 is RAS, 1 is LPS.
            case "coordinatesystem" ->
                sign = switch (value) {
                    case "LPS", "1" -> 1;
                    case "RAS", "0" -> -1;
                    default -> throw badInput(line, "found the axes " + Numbers.quote(value) + ", expected LPS or RAS");
                };
            case "columns" -> columns = Arrays.asList(value.split("\\s*,\\s*", -1));
            default -> {
                // Version, colours and what else the list may have.
            }
        }
    }

    private void readPoint(long line, String text) {
        String[] cells = cells(line, text);
        if (!isDefined(cells)) {
            return;
        }
        double[] position = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            String word = cell(cells, "xyz".substring(axis, axis + 1));
            position[axis] = Numbers.parse(word)
                    .orElseThrow(() -> badInput(
                            line, "found " + Numbers.quote(word) + ", expected three coordinates of a fiducial"));
        }
        rows.add(new String[] {
            cell(cells, "label"),
            Double.toString(sign * position[0]),
            Double.toString(sign * position[1]),
            Double.toString(position[2])
        });
        lines.add(line);
    }

    /** Whether the position of a point is set: where the row says nothing of it, it is. */
    private boolean isDefined(String[] cells) {
        int last = columns.indexOf(LAST_COLUMN);
        return last < 0 || cells.length <= last + 1 || !UNDEFINED.contains(cells[last + 1].strip());
    }

    private String[] cells(long line, String text) {
        try (CSVParser parser = CSVParser.parse(text, CSVFormat.RFC4180)) {
            return parser.iterator().next().values();
        } catch (IOException | UncheckedIOException broken) {
            throw new BadInputException(
                    badInput(line, "found a quoted cell that is broken, expected a closing quote")
                            .getMessage(),
                    broken);
        }
    }

    private String cell(String[] cells, String column) {
        int at = columns.indexOf(column);
        return at >= 0 && at < cells.length ? cells[at].strip() : "";
    }

    private BadInputException badInput(long line, String problem) {
        return BadInputException.at(file, "line " + line, problem);
    }
}
