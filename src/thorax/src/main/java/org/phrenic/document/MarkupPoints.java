package org.phrenic.document;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * Reader of the control points of 3D Slicer's markups ({@code .mrk.json}, schema 1.0) as a table with the columns name,
 * x_mm, y_mm, z_mm in LPS. Points without a defined position are left out.
 */
final class MarkupPoints {
    static final List<String> COLUMNS = List.of("name", "x_mm", "y_mm", "z_mm");
    private static final String ENDING = ".mrk.json";

    private record Point(String label, double[] position, long line) {}

    private final String file;
    private final JsonParser json;
    private final List<String[]> rows = new ArrayList<>();
    private final List<Long> lines = new ArrayList<>();

    private MarkupPoints(String file, JsonParser json) {
        this.file = file;
        this.json = json;
    }

    /** Whether the name of a file is that of markups. */
    static boolean isMarkups(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith(ENDING);
    }

    /** @throws BadInputException if the file is no JSON, has no markups, or a point without three finite numbers */
    static CsvTable read(Path path) {
        String file = path.toString();
        String text = TextFile.read(path, "markups of 3D Slicer");
        try (JsonParser json = new JsonFactory().createParser(text)) {
            MarkupPoints points = new MarkupPoints(file, json);
            points.readDocument();
            return CsvTable.of(file, COLUMNS, points.rows, points.lines);
        } catch (JsonProcessingException damaged) {
            long line =
                    damaged.getLocation() == null ? 1 : damaged.getLocation().getLineNr();
            throw BadInputException.at(
                    file, "line " + line, "found no JSON, expected markups of 3D Slicer (" + ENDING + ")");
        } catch (IOException failure) {
            throw new BadInputException(file + ": reading failed: " + failure.getMessage(), failure);
        }
    }

    private BadInputException badInput(String problem) {
        return BadInputException.at(file, "line " + json.currentLocation().getLineNr(), problem);
    }

    private void require(JsonToken token, String expected) {
        if (json.currentToken() != token) {
            throw badInput("found another value, expected " + expected);
        }
    }

    private void readDocument() throws IOException {
        json.nextToken();
        require(JsonToken.START_OBJECT, "markups of 3D Slicer");
        boolean found = false;
        while (json.nextToken() == JsonToken.FIELD_NAME) {
            boolean markups = json.currentName().equals("markups");
            json.nextToken();
            if (markups) {
                found = true;
                require(JsonToken.START_ARRAY, "a list of markups");
                while (json.nextToken() == JsonToken.START_OBJECT) {
                    readMarkup();
                }
                require(JsonToken.END_ARRAY, "a markup");
            } else {
                json.skipChildren();
            }
        }
        if (!found) {
            throw badInput("found no 'markups', expected those of 3D Slicer");
        }
    }

    private void readMarkup() throws IOException {
        double sign = 1;
        List<Point> points = new ArrayList<>();
        while (json.nextToken() == JsonToken.FIELD_NAME) {
            String key = json.currentName();
            json.nextToken();
            switch (key) {
                // Old files number the systems: 0 is RAS, 1 is LPS.
                case "coordinateSystem" ->
                    sign = switch (json.getText()) {
                        case "LPS", "1" -> 1;
                        case "RAS", "0" -> -1;
                        default ->
                            throw badInput("found the axes " + Numbers.quote(json.getText()) + ", expected LPS or RAS");
                    };
                case "coordinateUnits" -> {
                    String unit = unit();
                    if (!unit.equals("mm")) {
                        throw badInput("found the unit " + Numbers.quote(unit) + ", expected mm");
                    }
                }
                case "controlPoints" -> {
                    require(JsonToken.START_ARRAY, "a list of points");
                    while (json.nextToken() == JsonToken.START_OBJECT) {
                        readPoint(points);
                    }
                    require(JsonToken.END_ARRAY, "a point");
                }
                default -> json.skipChildren();
            }
        }
        for (Point point : points) {
            double[] p = point.position();
            String[] row = {point.label(), Double.toString(sign * p[0]), Double.toString(sign * p[1]), "" + p[2]};
            rows.add(row);
            lines.add(point.line());
        }
    }

    /** A unit by its symbol: a word, or the first of a list with its system and its meaning. */
    private String unit() throws IOException {
        if (json.currentToken() != JsonToken.START_ARRAY) {
            return json.getText();
        }
        json.nextToken();
        require(JsonToken.VALUE_STRING, "a unit");
        String unit = json.getText();
        while (json.nextToken() != JsonToken.END_ARRAY) {
            require(JsonToken.VALUE_STRING, "the words of a unit");
        }
        return unit;
    }

    private void readPoint(List<Point> points) throws IOException {
        long line = json.currentLocation().getLineNr();
        String label = "";
        double[] position = null;
        boolean isDefined = true;
        while (json.nextToken() == JsonToken.FIELD_NAME) {
            String key = json.currentName();
            json.nextToken();
            switch (key) {
                case "label" -> label = String.valueOf(json.getText());
                case "positionStatus" -> isDefined = json.getText().equals("defined");
                case "position" -> position = position();
                default -> {
                    // Orientation, visibility and what else a point may have.
                }
            }
            json.skipChildren();
        }
        if (isDefined) {
            if (position == null) {
                throw badInput("found a point without a position, expected three numbers");
            }
            points.add(new Point(label, position, line));
        }
    }

    /** Three numbers; null where the position is not set. */
    private double[] position() throws IOException {
        if (json.currentToken() == JsonToken.VALUE_NULL) {
            return null;
        }
        require(JsonToken.START_ARRAY, "a position of three numbers");
        double[] position = new double[3];
        for (int n = 0; n < 3; n++) {
            JsonToken token = json.nextToken();
            if (token == null || !token.isNumeric() || !Double.isFinite(json.getDoubleValue())) {
                throw badInput("found no number in a position, expected three");
            }
            position[n] = json.getDoubleValue();
        }
        json.nextToken();
        require(JsonToken.END_ARRAY, "a position of three numbers");
        return position;
    }
}
