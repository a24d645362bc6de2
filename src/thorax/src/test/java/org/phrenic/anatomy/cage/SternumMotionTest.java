package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.simulation.Runs;

/**
 * The sternum follows the anterior ends of the true ribs. A rigid motion of least squares carries the centroid of the
 * points onto the centroid of the moved points (Horn 1987, doi 10.1364/JOSAA.4.000629), whatever its rotation.
 */
class SternumMotionTest {
    private static final int LAST_TRUE_RIB = 7;

    /** With ribs of one side the motion is not symmetric, so its helical axis has a slide. */
    @Test
    void theCentroidOfTheEndsOfTheRibsGoesWhereTheRibsCarryIt() {
        Thorax male = Runs.male();
        List<Structure> kept =
                male.structures().stream().filter(s -> s.side() != Side.LEFT).toList();
        Thorax oneSided = new Thorax("right side", kept, List.of());
        RibCage cage = RibCage.of(oneSided, RibAxisTable.preset(RibAxisTable.WILSON_CT), true);
        double[] rest = new double[3];
        double[] moved = new double[3];
        for (RibCage.Body rib : cage.bodies()) {
            if (rib.ends().isPresent() && rib.level() <= LAST_TRUE_RIB) {
                add(rest, rib.ends().orElseThrow().anterior());
                add(
                        moved,
                        apply(rib.axis().orElseThrow(), rib.ends().orElseThrow().anterior()));
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            rest[axis] /= LAST_TRUE_RIB;
            moved[axis] /= LAST_TRUE_RIB;
        }
        HelicalAxis sternum = cage.bodies().get(cage.sternum()).axis().orElseThrow();
        assertThat(Math.abs(sternum.slide())).as("slide, mm").isGreaterThan(0.5);
        double[] carried = apply(sternum, rest);
        for (int axis = 0; axis < 3; axis++) {
            assertThat(carried[axis]).isCloseTo(moved[axis], within(1e-9));
        }
    }

    private static double[] apply(HelicalAxis axis, double[] p) {
        return axis.motion().apply(p[0], p[1], p[2]);
    }

    private static void add(double[] sum, double[] p) {
        for (int axis = 0; axis < 3; axis++) {
            sum[axis] += p[axis];
        }
    }
}
