package org.phrenic.mesh.voxel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.IntList;

/** Arcs of rods about an upright axis in voxels of 2 mm, of 6 mm thickness. */
class LayerPartingTest {
    private static final int SIZE = 100;
    private static final double[] AXIS = {100, 100};
    private static final double RADIUS_MM = 80;
    private static final double HALF_THICKNESS_MM = 3;

    private final byte[] labels = new byte[SIZE * SIZE * SIZE];
    private final LabelGrid grid =
            LabelGrid.of(SIZE, SIZE, SIZE, labels, new double[] {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0});

    /** Adds a rod from one direction to another, of which height and distance from the axis change evenly. */
    private void rod(double fromDegrees, double toDegrees, double[] fromMm, double[] toMm) {
        for (int step = 0; step <= 300; step++) {
            double share = step / 300.0;
            double angle = Math.toRadians(fromDegrees + share * (toDegrees - fromDegrees));
            double radius = fromMm[0] + share * (toMm[0] - fromMm[0]);
            ball(
                    AXIS[0] + radius * StrictMath.cos(angle),
                    AXIS[1] + radius * StrictMath.sin(angle),
                    fromMm[1] + share * (toMm[1] - fromMm[1]));
        }
    }

    private void ball(double x, double y, double z) {
        int reach = 2;
        for (int k = (int) (z / 2) - reach; k <= z / 2 + reach; k++) {
            for (int j = (int) (y / 2) - reach; j <= y / 2 + reach; j++) {
                for (int i = (int) (x / 2) - reach; i <= x / 2 + reach; i++) {
                    double square = (2 * i - x) * (2 * i - x) + (2 * j - y) * (2 * j - y) + (2 * k - z) * (2 * k - z);
                    if (square <= HALF_THICKNESS_MM * HALF_THICKNESS_MM) {
                        labels[i + SIZE * (j + SIZE * k)] = 1;
                    }
                }
            }
        }
    }

    private Optional<LayerParting.Layers> parted() {
        IntList body = new IntList();
        for (int v = 0; v < labels.length; v++) {
            if (labels[v] > 0) {
                body.add(v);
            }
        }
        return LayerParting.part(grid, body, AXIS);
    }

    private void level(double height, double toDegrees) {
        rod(-80, toDegrees, new double[] {RADIUS_MM, height}, new double[] {RADIUS_MM, height});
    }

    @Test
    void layersThatShareTheirEndsAreParted() {
        level(60, 70);
        level(86, 70);
        level(112, 70);
        for (double z = 60; z <= 112; z++) {
            rod(68, 70, new double[] {RADIUS_MM, z}, new double[] {RADIUS_MM, z});
        }
        LayerParting.Layers layers = parted().orElseThrow();
        assertThat(layers.count()).isEqualTo(3);
        assertThat(layers.pieces()).hasSize(3);
        int all = layers.pieces().stream().mapToInt(IntList::size).sum();
        assertThat(layers.pieces())
                .allSatisfy(piece -> assertThat(piece.size() / (double) all).isCloseTo(1 / 3.0, within(0.03)));
        assertThat(StrictMath.atan2(layers.joint()[1] - AXIS[1], layers.joint()[0] - AXIS[0]))
                .isCloseTo(Math.toRadians(68), within(0.05));
    }

    @Test
    void aSteepRodIsOneLayer() {
        rod(-80, 80, new double[] {RADIUS_MM, 180}, new double[] {RADIUS_MM, 20});
        assertThat(parted()).isEmpty();
    }

    /** As a last rib that begins at a vertebra which lies before the axis. */
    @Test
    void aRodThatTurnsBackAwayFromTheAxisIsOneLayer() {
        rod(20, 70, new double[] {25, 140}, new double[] {55, 100});
        rod(70, 20, new double[] {55, 100}, new double[] {85, 60});
        assertThat(parted()).isEmpty();
    }
}
