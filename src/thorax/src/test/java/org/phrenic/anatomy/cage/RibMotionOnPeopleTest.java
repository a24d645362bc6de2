package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.descriptive.rank.Percentile.EstimationType;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.TriangleMesh;

/**
 * The default table on the ribs of a real thorax, at full inspiration, against 202 motions of ribs measured in CT of 17
 * people: every anterior end from rib 3 to 9 must rise and go forward as the middle half of the people's do (both sides
 * pooled).
 */
class RibMotionOnPeopleTest {
    /** Columns x toward R, y posterior, z superior. */
    private static final String MEASURED = "ribs/helical_axes_ct.csv";

    @Test
    void anteriorEndsMoveWithinTheMiddleHalfOfPeople() throws IOException {
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        for (int level = 3; level <= 9; level++) {
            double[] rise = quartiles(level, "dAnt_z_mm", 1);
            double[] forward = quartiles(level, "dAnt_y_mm", -1);
            for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
                TriangleMesh rib = SharedRibs.rib("anatomy/male-thorax/watertight", level, side);
                double[] before = RibEnds.find(rib, side).anterior();
                double[] after = table.axis(level, side, RibEnds.find(rib, side).head())
                        .motion()
                        .apply(before[0], before[1], before[2]);
                assertThat(after[2] - before[2])
                        .as("rise of rib %d %s, mm", level, side)
                        .isBetween(rise[0], rise[1]);
                assertThat(before[1] - after[1])
                        .as("forward of rib %d %s, mm", level, side)
                        .isBetween(forward[0], forward[1]);
            }
        }
    }

    @Test
    void ribsSwingOutward() throws IOException {
        for (String name : new String[] {RibAxisTable.WILSON_CT, RibAxisTable.NECK}) {
            RibAxisTable table = RibAxisTable.preset(name);
            for (int level = 2; level <= 12; level++) {
                TriangleMesh rib = SharedRibs.rib("anatomy/male-thorax/watertight", level, Side.LEFT);
                RigidMotion motion = table.axis(
                                level, Side.LEFT, RibEnds.find(rib, Side.LEFT).head())
                        .motion();
                double[] moved = rib.positions().clone();
                motion.apply(moved);
                assertThat(rib.withPositions(moved).bounds()[3] - rib.bounds()[3])
                        .as("%s, widening by rib %d, mm", name, level)
                        .isPositive();
            }
        }
    }

    private static double[] quartiles(int level, String column, int sign) throws IOException {
        List<Double> values = new ArrayList<>();
        try (Reader reader = Files.newBufferedReader(SharedRibs.file(MEASURED))) {
            CSVFormat format = CSVFormat.DEFAULT
                    .builder()
                    .setHeader()
                    .setSkipHeaderRecord(true)
                    .get();
            for (CSVRecord row : format.parse(reader)) {
                if (Integer.parseInt(row.get("rib")) == level) {
                    values.add(sign * Double.parseDouble(row.get(column)));
                }
            }
        }
        // R_7, the straight line between order statistics, as NumPy and R have it by default
        Percentile percentile = new Percentile().withEstimationType(EstimationType.R_7);
        percentile.setData(values.stream().mapToDouble(Double::doubleValue).toArray());
        return new double[] {percentile.evaluate(25), percentile.evaluate(75)};
    }
}
