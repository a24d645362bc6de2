package org.phrenic.anatomy.cage;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.document.CsvTable;
import org.phrenic.document.ShippedFile;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.file.BadInputException;

/**
 * Rotation of each rib from end-expiration to full inspiration.
 *
 * <p>The rotation vector in LPS is {@code (-pump, bucket, swing)} for a right rib and {@code (-pump, -bucket, -swing)}
 * for a left rib. Its direction is the axis and its length the angle. The axis passes through the head of the rib. Two
 * tables are built in, {@code data/ribs/axes-wilson-ct.csv} and {@code axes-neck.csv}; each row states its source.
 * {@code docs/rib-kinematics.md} gives the reasons for the first.
 */
public final class RibAxisTable {
    /** Measured axes (T. A. Wilson et al. 1987 and CT); the default. */
    public static final String WILSON_CT = "axes-wilson-ct";

    /** Anatomical axes of the rib necks. */
    public static final String NECK = "axes-neck";

    private static final int LEVELS = 12;
    private static final double ANGLE_TOLERANCE_DEG = 0.1;
    private static final double LARGEST_DEG = 90;

    private final List<Row> rows;

    /**
     * Motion of one rib.
     *
     * @param pumpDeg rotation about the transverse axis; positive raises the anterior end
     * @param bucketDeg rotation about the antero-posterior axis; positive raises the lateral arc
     * @param swingDeg rotation about the superior axis; positive moves the anterior end toward the midline
     * @param slideMm translation along the axis (right rib; mirrored for the left)
     */
    public record Row(double pumpDeg, double bucketDeg, double swingDeg, double slideMm) {
        /** Length of the rotation vector, degrees. */
        public double angleDeg() {
            return Math.sqrt(pumpDeg * pumpDeg + bucketDeg * bucketDeg + swingDeg * swingDeg);
        }
    }

    private RibAxisTable(List<Row> rows) {
        this.rows = List.copyOf(rows);
    }

    /**
     * Returns a built-in table.
     *
     * @param name {@link #WILSON_CT} or {@link #NECK}
     * @throws BadInputException if there is no table of this name
     */
    public static RibAxisTable preset(String name) {
        if (!name.equals(WILSON_CT) && !name.equals(NECK)) {
            throw new BadInputException(
                    "rib axes: no table '" + name + "', expected '" + WILSON_CT + "' or '" + NECK + "'");
        }
        return parse(name + ".csv", ShippedFile.text("ribs/" + name + ".csv"));
    }

    /**
     * Parses a table in CSV; lines that begin with # are comments.
     *
     * @throws BadInputException if a value is missing or out of range; the message names line and column
     */
    static RibAxisTable parse(String name, String text) {
        CsvTable table = CsvTable.parse(name, text, '#');
        double[] level = table.numbers("rib");
        double[] pump = table.numbers("pump_deg");
        double[] bucket = table.numbers("bucket_deg");
        double[] swing = table.numbers("swing_deg");
        double[] slide = table.numbers("slide_mm");
        double[] angle = table.numbers("angle_deg");
        Row[] rows = new Row[LEVELS];
        for (int i = 0; i < level.length; i++) {
            int at = (int) level[i] - 1;
            if (at + 1 != level[i] || at < 0 || at >= LEVELS) {
                throw table.badCell(i, "rib", "found " + level[i] + ", expected 1 to " + LEVELS);
            }
            if (rows[at] != null) {
                throw table.badCell(i, "rib", "found rib " + (at + 1) + " a second time, expected it once");
            }
            rows[at] = new Row(pump[i], bucket[i], swing[i], slide[i]);
            if (Math.abs(angle[i] - rows[at].angleDeg()) > ANGLE_TOLERANCE_DEG) {
                throw table.badCell(
                        i,
                        "angle_deg",
                        "found " + angle[i] + ", expected the length of pump, bucket and swing, "
                                + rows[at].angleDeg());
            }
            if (angle[i] > LARGEST_DEG || angle[i] <= 0) {
                throw table.badCell(
                        i, "angle_deg", "found " + angle[i] + ", expected more than 0, at most " + LARGEST_DEG);
            }
        }
        int missing = Arrays.asList(rows).indexOf(null);
        if (missing >= 0) {
            throw new BadInputException(
                    name + ": found no line for rib " + (missing + 1) + ", expected ribs 1 to " + LEVELS);
        }
        return new RibAxisTable(Arrays.asList(rows));
    }

    /** Row of a rib, level 1 to 12. */
    public Row row(int level) {
        return rows.get(level - 1);
    }

    /**
     * Motion of a rib to full inspiration.
     *
     * @param level 1 to 12
     * @param side right or left
     * @param head head of the rib, LPS, mm
     */
    public HelicalAxis axis(int level, Side side, double[] head) {
        Row row = row(level);
        double[] direction = {-row.pumpDeg(), row.bucketDeg(), row.swingDeg()};
        double angle = Math.toRadians(row.angleDeg());
        double[] rightHead = side == Side.LEFT ? new double[] {-head[0], head[1], head[2]} : head;
        HelicalAxis right = HelicalAxis.through(direction, rightHead, angle, row.slideMm());
        return side == Side.LEFT ? right.mirroredX() : right;
    }
}
