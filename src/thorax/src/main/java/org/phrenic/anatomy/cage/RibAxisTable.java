package org.phrenic.anatomy.cage;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.phrenic.anatomy.Side;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.mesh.TriangleMesh;

/**
 * How far and about which direction each rib turns from end-expiration to full inspiration.
 *
 * <p>The rotation vector of the right rib in LPS is {@code (-pump, bucket, swing)}, of the left rib {@code (-pump,
 * -bucket, -swing)}: its direction is the axis, its length the angle. The axis passes through the head of the rib. Two
 * tables come with the program, {@code data/ribs/axes-wilson-ct.csv} and {@code axes-neck.csv}; they name their
 * sources, row by row, and {@code docs/rib-kinematics.md} says how the first was chosen.
 */
public final class RibAxisTable {
    /** Measured axes of motion: T. A. Wilson et al. 1987 and CT; the default. */
    public static final String WILSON_CT = "axes-wilson-ct";

    /** The anatomical axes of the necks of the ribs. */
    public static final String NECK = "axes-neck";

    private static final int LEVELS = 12;
    private static final double ANGLE_TOLERANCE_DEG = 0.1;
    private static final double LARGEST_DEG = 90;

    private final List<Row> rows;

    /**
     * One rib.
     *
     * @param level 1 to 12
     * @param pumpDeg about the transverse axis, positive raises the anterior end
     * @param bucketDeg about the antero-posterior axis, positive raises the lateral arc
     * @param swingDeg about the superior axis, positive carries the anterior end to the midline, negative away from it
     * @param slideMm along the axis (of the right rib; the left mirrors it)
     * @param confidence good, fair or weak
     * @param source where the numbers come from
     */
    public record Row(
            int level,
            double pumpDeg,
            double bucketDeg,
            double swingDeg,
            double slideMm,
            String confidence,
            String source) {

        /** Length of the rotation vector, degrees. */
        public double angleDeg() {
            return Math.sqrt(pumpDeg * pumpDeg + bucketDeg * bucketDeg + swingDeg * swingDeg);
        }
    }

    private RibAxisTable(List<Row> rows) {
        this.rows = List.copyOf(rows);
    }

    /**
     * A table that comes with the program.
     *
     * @param name {@link #WILSON_CT} or {@link #NECK}
     * @throws IOException if there is none of that name
     */
    public static RibAxisTable preset(String name) throws IOException {
        String resource = "/org/phrenic/data/ribs/" + name + ".csv";
        try (InputStream in = RibAxisTable.class.getResourceAsStream(resource)) {
            if (in == null) {
                throw new IOException(
                        "rib axes: no table '" + name + "', expected '" + WILSON_CT + "' or '" + NECK + "'");
            }
            return read(new InputStreamReader(in, StandardCharsets.UTF_8), name + ".csv");
        }
    }

    /**
     * Reads a table of the same columns from a file.
     *
     * @throws IOException if it cannot be read or a value is missing or out of range; the message names the line
     */
    public static RibAxisTable read(Path file) throws IOException {
        try (Reader reader = Files.newBufferedReader(file)) {
            return read(reader, file.toString());
        }
    }

    static RibAxisTable read(Reader reader, String name) throws IOException {
        CSVFormat format = CSVFormat.DEFAULT
                .builder()
                .setCommentMarker('#')
                .setHeader()
                .setSkipHeaderRecord(true)
                .setTrim(true)
                .get();
        Row[] found = new Row[LEVELS + 1];
        try (CSVParser parser = CSVParser.parse(reader, format)) {
            for (CSVRecord csv : parser) {
                String place = name + " line " + parser.getCurrentLineNumber();
                Row row = row(csv, place);
                if (found[row.level()] != null) {
                    throw new IOException(place + ": rib " + row.level() + " for a second time, expected it once");
                }
                found[row.level()] = row;
            }
        } catch (UncheckedIOException e) {
            // how the parser passes on what its reader throws
            throw new IOException(name + ": " + e.getCause().getMessage() + ", expected a CSV file in UTF-8", e);
        }
        List<Row> rows = new ArrayList<>();
        for (int level = 1; level <= LEVELS; level++) {
            if (found[level] == null) {
                throw new IOException(name + ": no line for rib " + level + ", expected ribs 1 to " + LEVELS);
            }
            rows.add(found[level]);
        }
        return new RibAxisTable(rows);
    }

    private static Row row(CSVRecord csv, String place) throws IOException {
        double level = number(csv, "rib", place);
        if (level != Math.rint(level) || level < 1 || level > LEVELS) {
            throw new IOException(place + ": rib " + text(csv, "rib", place) + ", expected 1 to " + LEVELS);
        }
        Row row = new Row(
                (int) level,
                number(csv, "pump_deg", place),
                number(csv, "bucket_deg", place),
                number(csv, "swing_deg", place),
                number(csv, "slide_mm", place),
                text(csv, "confidence", place),
                text(csv, "source", place));
        double angle = number(csv, "angle_deg", place);
        if (Math.abs(angle - row.angleDeg()) > ANGLE_TOLERANCE_DEG) {
            throw new IOException(place + ": angle_deg " + angle + ", expected the length of pump, bucket and swing, "
                    + row.angleDeg());
        }
        if (angle > LARGEST_DEG || angle <= 0) {
            throw new IOException(place + ": angle_deg " + angle + ", expected more than 0, at most " + LARGEST_DEG);
        }
        return row;
    }

    private static String text(CSVRecord csv, String column, String place) throws IOException {
        if (!csv.isMapped(column) || !csv.isSet(column)) {
            throw new IOException(place + ": no column '" + column
                    + "', expected rib, pump_deg, bucket_deg, swing_deg, " + "slide_mm, angle_deg, confidence, source");
        }
        return csv.get(column);
    }

    private static double number(CSVRecord csv, String column, String place) throws IOException {
        String text = text(csv, column, place);
        try {
            double value = Double.parseDouble(text);
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // said below, with its place
        }
        throw new IOException(place + ": " + column + " '" + text + "', expected a number");
    }

    /** Ribs 1 to 12. */
    public List<Row> rows() {
        return rows;
    }

    /** The row of a rib, level 1 to 12. */
    public Row row(int level) {
        return rows.get(level - 1);
    }

    /**
     * The motion of a rib to full inspiration.
     *
     * @param level 1 to 12
     * @param side right or left
     * @param head of the rib, LPS, mm
     */
    public HelicalAxis axis(int level, Side side, double[] head) {
        Row row = row(level);
        double[] direction = {-row.pumpDeg(), row.bucketDeg(), row.swingDeg()};
        double angle = Math.toRadians(row.angleDeg());
        double[] rightHead = side == Side.LEFT ? new double[] {-head[0], head[1], head[2]} : head;
        HelicalAxis right = HelicalAxis.through(direction, rightHead, angle, row.slideMm());
        return side == Side.LEFT ? right.mirroredX() : right;
    }

    /** The motion of a rib to full inspiration, its head found on its surface (LPS, mm). */
    public HelicalAxis axis(int level, Side side, TriangleMesh rib) {
        return axis(level, side, RibEnds.find(rib, side).head());
    }
}
