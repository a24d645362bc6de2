package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;

/** Volumes that end with their structures. */
class EmptyLayersTest {
    /** Columns, rows and slices of 1, 1 and 3 mm; the first voxel at (7, 8, 9). */
    private static final double[] TO_MM = {1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 3, 9};

    private static final int SIDE = 20;

    private interface Shape {
        boolean holds(double x, double y, double z);
    }

    /** Part of a volume of 20 voxels along each direction, from their middle. */
    private static LabelGrid part(int label, int[] from, int[] to, Shape shape) {
        int[] size = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        short[] labels = new short[size[0] * size[1] * size[2]];
        for (int v = 0; v < labels.length; v++) {
            double x = v % size[0] + from[0] - 9.5;
            double y = v / size[0] % size[1] + from[1] - 9.5;
            double z = v / (size[0] * size[1]) + from[2] - 9.5;
            labels[v] = (short) (shape.holds(x, y, z) ? label : 0);
        }
        return LabelGrid.of(size[0], size[1], size[2], labels, TO_MM);
    }

    private static boolean isInBall(double x, double y, double z) {
        return x * x + y * y + z * z < 100;
    }

    private static LabelGrid ball(int label) {
        return part(label, new int[3], new int[] {SIDE, SIDE, SIDE}, EmptyLayersTest::isInBall);
    }

    private static int[] box(LabelGrid grid) {
        return grid.box(label -> label > 0);
    }

    /** A label above 255 takes two bytes. */
    @Test
    void aVolumeThatIsCroppedToAStructureDoesNotEndAtIt() {
        for (int label : new int[] {1, 300}) {
            LabelGrid whole = ball(label);
            LabelGrid padded = EmptyLayers.beyond(whole);
            assertThat(box(padded)).containsExactly(1, 1, 1, SIDE, SIDE, SIDE);
            assertThat(new int[] {padded.columns(), padded.rows(), padded.slices()})
                    .containsOnly(SIDE + 2);
            double[] at = new double[3];
            padded.voxelToMm(1, 1, 1, at);
            assertThat(at).as("where the first voxel was").containsExactly(7, 8, 9);
            assertThat(padded.counts()[label]).isEqualTo(whole.counts()[label]);
            for (int[] v : new int[][] {{0, 9, 9}, {9, 12, 3}, {19, 10, 9}, {1, 2, 3}}) {
                assertThat(padded.label(v[0] + 1, v[1] + 1, v[2] + 1)).isEqualTo(whole.label(v[0], v[1], v[2]));
            }
        }
    }

    /** Each face alone, 4 layers into the ball: its last section has 0.81 of the area of the one two layers farther. */
    @Test
    void aFaceAtWhichAStructureIsCutThroughStaysOneOfTheScan() {
        for (int direction = 0; direction < 3; direction++) {
            for (boolean last : new boolean[] {false, true}) {
                int[] from = new int[3];
                int[] to = {SIDE, SIDE, SIDE};
                if (last) {
                    to[direction] -= 4;
                } else {
                    from[direction] = 4;
                }
                int[] box = box(EmptyLayers.beyond(part(1, from, to, EmptyLayersTest::isInBall)));
                for (int other = 0; other < 3; other++) {
                    boolean cutBefore = other == direction && !last;
                    assertThat(box[other]).isEqualTo(cutBefore ? 0 : 1);
                    int length = to[other] - from[other];
                    assertThat(box[3 + other]).isEqualTo(cutBefore ? length - 1 : length);
                }
            }
        }
    }

    @Test
    void aStructureThatIsCutThroughBesideOneThatEndsMakesTheFaceOneOfTheScan() {
        Shape withColumn = (x, y, z) -> isInBall(x, y, z) || (x > 8 && y > 8);
        LabelGrid grid = EmptyLayers.beyond(part(1, new int[3], new int[] {SIDE, SIDE, SIDE}, withColumn));
        assertThat(box(grid)[2]).isOne();
        short[] two = new short[SIDE * SIDE * SIDE];
        LabelGrid one = ball(1);
        for (int v = 0; v < two.length; v++) {
            two[v] = (short) (v % SIDE > 17 && v / SIDE % SIDE > 17 ? 2 : one.label(v));
        }
        LabelGrid padded = EmptyLayers.beyond(LabelGrid.of(SIDE, SIDE, SIDE, two, TO_MM));
        assertThat(padded.slices())
                .as("a column of another label from end to end")
                .isEqualTo(SIDE);
        assertThat(padded.columns()).as("whose flat side is there").isEqualTo(SIDE + 1);
    }

    /** The arch of a rib of 8 voxels that the last layer touches over a quarter of its depth. */
    @Test
    void theArchOfARibEndsWhereItIsTouched() {
        Shape arch = (x, y, z) -> {
            double r = Math.hypot(x + 90.25, y);
            return r < 100 && r > 92 && Math.abs(z) < 5;
        };
        LabelGrid whole = part(1, new int[] {-20, -40, 0}, new int[] {SIDE, 60, SIDE}, arch);
        int[] box = box(whole);
        LabelGrid cropped = part(1, new int[] {-20, -40, 0}, new int[] {box[3] - 19, 60, SIDE}, arch);
        assertThat(EmptyLayers.beyond(cropped).columns()).isEqualTo(cropped.columns() + 1);
        LabelGrid cut = part(1, new int[] {-20, -40, 0}, new int[] {box[3] - 22, 60, SIDE}, arch);
        assertThat(EmptyLayers.beyond(cut).columns())
                .as("3 voxels of it missing")
                .isEqualTo(cut.columns());
    }

    /** Five slices, the first with some and the others with 100 voxels of a structure in the middle. */
    private static LabelGrid stub(int first) {
        byte[] labels = new byte[5 * SIDE * SIDE];
        for (int k = 0; k < 5; k++) {
            int from = k * SIDE * SIDE + 7 * SIDE + 1;
            for (int v = 0; v < (k == 0 ? first : 100); v++) {
                labels[from + v % 18 + v / 18 * SIDE] = 1;
            }
        }
        return LabelGrid.of(SIDE, SIDE, 5, labels, TO_MM);
    }

    @Test
    void aStructureEndsWithUpToTwoThirdsOfItsSectionTwoLayersFartherIn() {
        assertThat(EmptyLayers.beyond(stub(65)).slices()).isEqualTo(6);
        assertThat(EmptyLayers.beyond(stub(66)).slices()).isEqualTo(5);
    }

    /** A rod of 9 voxels to the first slice and a plate of 90 in the last ones, as of a spinous process. */
    @Test
    void theTipOfAStructureEndsIt() {
        for (int rod : new int[] {9, 10}) {
            byte[] labels = new byte[10 * SIDE * SIDE];
            for (int k = 0; k < 9; k++) {
                int from = k * SIDE * SIDE + 7 * SIDE + 1;
                for (int v = 0; v < (k < 5 ? rod : 90); v++) {
                    labels[from + v % 18 + v / 18 * SIDE] = 1;
                }
            }
            LabelGrid grid = LabelGrid.of(SIDE, SIDE, 10, labels, TO_MM);
            assertThat(EmptyLayers.beyond(grid).slices()).isEqualTo(rod == 9 ? 11 : 10);
        }
    }

    @Test
    void aVolumeWithoutRoomForMoreLayersIsNotExtended() {
        assertThat(EmptyLayers.fits(1024, 1024, 2047)).isTrue();
        assertThat(EmptyLayers.fits(1024, 1024, 2049)).isFalse();
        assertThat(EmptyLayers.fits(1 << 16, 1 << 16, 2)).isFalse();
    }

    @Test
    void facesThatNothingTouchesStayAsTheyAre() {
        LabelGrid padded = EmptyLayers.beyond(ball(1));
        assertThat(EmptyLayers.beyond(padded)).isSameAs(padded);
        LabelGrid empty = LabelGrid.of(SIDE, SIDE, SIDE, new byte[SIDE * SIDE * SIDE], TO_MM);
        assertThat(EmptyLayers.beyond(empty)).isSameAs(empty);
        LabelVolume volume = new LabelVolume(ball(1), Map.of(1, "liver"), List.of("a note"));
        LabelVolume whole = volume.withEmptyLayers();
        assertThat(Arrays.equals(box(whole.grid()), box(padded))).isTrue();
        assertThat(whole.names()).isEqualTo(volume.names());
        assertThat(whole.notes()).isEqualTo(volume.notes());
        assertThat(whole.withEmptyLayers()).isSameAs(whole);
    }
}
