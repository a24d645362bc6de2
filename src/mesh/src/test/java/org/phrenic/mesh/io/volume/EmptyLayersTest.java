package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.volume.LabelVolume.Extent;
import org.phrenic.mesh.voxel.LabelGrid;

/** Volumes that end with their structures. */
class EmptyLayersTest {
    /** Columns of 3 mm along y, rows of 2 mm against x, slices of 3 mm along z; the first voxel at (7, 8, 9). */
    private static final double[] TO_MM = {0, -2, 0, 7, 3, 0, 0, 8, 0, 0, 3, 9};

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

    private static void assertPlace(LabelGrid grid, int[] voxel, LabelGrid of, int[] same) {
        double[] at = new double[3];
        double[] was = new double[3];
        grid.voxelToMm(voxel[0], voxel[1], voxel[2], at);
        of.voxelToMm(same[0], same[1], same[2], was);
        assertThat(at).containsExactly(was);
    }

    /** A label above 255 takes two bytes. */
    @Test
    void aVolumeThatIsCroppedToAStructureDoesNotEndAtIt() {
        for (int label : new int[] {1, 300}) {
            LabelGrid whole = ball(label);
            LabelGrid padded = EmptyLayers.beyond(whole, Extent.FIELD);
            assertThat(box(padded)).containsExactly(1, 1, 1, SIDE, SIDE, SIDE);
            assertThat(new int[] {padded.columns(), padded.rows(), padded.slices()})
                    .containsOnly(SIDE + 2);
            assertPlace(padded, new int[] {1, 1, 1}, whole, new int[3]);
            assertThat(padded.counts()[label]).isEqualTo(whole.counts()[label]);
            for (int[] v : new int[][] {{0, 9, 9}, {9, 12, 3}, {19, 10, 9}, {1, 2, 3}}) {
                assertThat(padded.label(v[0] + 1, v[1] + 1, v[2] + 1)).isEqualTo(whole.label(v[0], v[1], v[2]));
            }
        }
    }

    /** Each face alone, 4 layers into the ball, whose last section has 0.87 of the area of the next one. */
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
                LabelGrid cut = part(1, from, to, EmptyLayersTest::isInBall);
                LabelGrid padded = EmptyLayers.beyond(cut, Extent.FIELD);
                int[] box = box(padded);
                for (int other = 0; other < 3; other++) {
                    boolean cutBefore = other == direction && !last;
                    assertThat(box[other]).isEqualTo(cutBefore ? 0 : 1);
                    int length = to[other] - from[other];
                    assertThat(box[3 + other]).isEqualTo(cutBefore ? length - 1 : length);
                }
                int sizes = padded.columns() + padded.rows() + padded.slices();
                assertThat(sizes).isEqualTo(cut.columns() + cut.rows() + cut.slices() + 5);
                assertPlace(padded, new int[] {box[0], box[1], box[2]}, cut, new int[3]);
            }
        }
    }

    /**
     * A volume of the whole field, in which a scan that ends 10 mm below the top of an organ leaves a small section.
     */
    @Test
    void structuresAtTwoFacesDoNotShowThatAVolumeIsCropped() {
        LabelGrid field = part(1, new int[] {-2, -2, 0}, new int[] {22, 22, SIDE}, EmptyLayersTest::isInBall);
        assertThat(EmptyLayers.beyond(field, Extent.FIELD)).isSameAs(field);
        assertThat(EmptyLayers.beyond(field, Extent.LABELS).slices())
                .as("in a file that leaves out empty slices")
                .isEqualTo(SIDE + 2);
        LabelGrid oneEnd = part(1, new int[] {-2, -2, 0}, new int[] {22, 22, 22}, EmptyLayersTest::isInBall);
        assertThat(EmptyLayers.beyond(oneEnd, Extent.LABELS))
                .as("it has an empty slice at the other end")
                .isSameAs(oneEnd);
    }

    @Test
    void aStructureThatIsCutThroughBesideOneThatEndsMakesTheFaceOneOfTheScan() {
        LabelGrid one = ball(1);
        short[] two = new short[SIDE * SIDE * SIDE];
        for (int v = 0; v < two.length; v++) {
            two[v] = (short) (v % SIDE > 13 && v / SIDE % SIDE > 13 ? 2 : one.label(v));
        }
        LabelGrid padded = EmptyLayers.beyond(LabelGrid.of(SIDE, SIDE, SIDE, two, TO_MM), Extent.FIELD);
        assertThat(padded.slices())
                .as("a column of another label from end to end")
                .isEqualTo(SIDE);
        assertThat(padded.columns()).as("whose flat side is there").isEqualTo(SIDE + 1);
    }

    /** The arch of a rib of 8 voxels that the last layer touches, and that ends at the other faces. */
    @Test
    void theArchOfARibEndsWhereItIsTouched() {
        Shape arch = (x, y, z) -> {
            double r = Math.hypot(x + 90.25, y);
            return r < 100 && r > 92 && Math.abs(z) < 5;
        };
        int[] from = {0, -60, 0};
        int end = box(part(1, from, new int[] {30, 80, SIDE}, arch))[3] + 1;
        LabelGrid cropped = part(1, from, new int[] {end, 80, SIDE}, arch);
        assertThat(EmptyLayers.beyond(cropped, Extent.LABELS).columns()).isEqualTo(cropped.columns() + 1);
        LabelGrid cut = part(1, from, new int[] {end - 3, 80, SIDE}, arch);
        assertThat(EmptyLayers.beyond(cut, Extent.LABELS).columns())
                .as("3 voxels of it missing")
                .isEqualTo(cut.columns());
    }

    /** Slices with so many voxels of a structure in their middle. */
    private static LabelGrid stack(int... voxels) {
        byte[] labels = new byte[voxels.length * SIDE * SIDE];
        for (int k = 0; k < voxels.length; k++) {
            int from = k * SIDE * SIDE + 7 * SIDE + 1;
            for (int v = 0; v < voxels[k]; v++) {
                labels[from + v % 18 + v / 18 * SIDE] = 1;
            }
        }
        return LabelGrid.of(SIDE, SIDE, voxels.length, labels, TO_MM);
    }

    @Test
    void aStructureEndsWithUpToAHalfOfItsSectionInTheNextLayerAndAThinOneWithThreeQuarters() {
        for (int[] thin : new int[][] {{75, 100, 80, 80}, {75, 80, 100, 80}, {55, 100, 80, 80}}) {
            assertThat(slices(stack(thin))).isEqualTo(5);
        }
        for (int[] cut : new int[][] {{76, 100, 100, 80}, {75, 80, 80, 100}, {100, 100, 80, 80}}) {
            assertThat(slices(stack(cut))).isEqualTo(4);
        }
        // 200 voxels of 6 mm^2 are not thin.
        assertThat(slices(stack(110, 200, 180, 180))).isEqualTo(5);
        assertThat(slices(stack(111, 200, 180, 180))).isEqualTo(4);
        assertThat(slices(stack(111, 150, 220, 180))).isEqualTo(4);
    }

    private static int slices(LabelGrid grid) {
        return EmptyLayers.beyond(grid, Extent.LABELLED_SLICES).slices();
    }

    /** Voxels of 6 mm^2 along slices, 9 along rows. */
    @Test
    void aTipOfOneAndAHalfSquareCentimetresEndsAStructure() {
        assertThat(slices(stack(25, 25, 25, 90, 90))).isEqualTo(6);
        assertThat(slices(stack(26, 26, 26, 90, 90))).isEqualTo(5);
        for (int voxels : new int[] {16, 17}) {
            byte[] labels = new byte[SIDE * SIDE * 3];
            for (int v = 0; v < labels.length; v++) {
                int column = v % SIDE;
                boolean rod = v / (SIDE * SIDE) == 1 && column > 0 && column <= voxels;
                labels[v] = (byte) (rod ? 1 : 0);
            }
            LabelGrid along = LabelGrid.of(SIDE, SIDE, 3, labels, TO_MM);
            assertThat(EmptyLayers.beyond(along, Extent.LABELS).rows()).isEqualTo(voxels == 16 ? SIDE + 2 : SIDE);
        }
    }

    /** What leaves out slices has the columns and rows of the field of view. */
    @Test
    void onlyInDirectionsThatLeaveOutLayersDoesAVolumeEndWithItsStructures() {
        LabelGrid ofField = part(1, new int[] {0, 0, -1}, new int[] {SIDE, SIDE, 21}, EmptyLayersTest::isInBall);
        assertThat(EmptyLayers.beyond(ofField, Extent.LABELLED_SLICES)).isSameAs(ofField);
        LabelGrid masks = EmptyLayers.beyond(ofField, Extent.LABELS);
        assertThat(new int[] {masks.columns(), masks.rows(), masks.slices()})
                .containsExactly(SIDE + 2, SIDE + 2, SIDE + 2);
    }

    @Test
    void aSpeckDoesNotMakeAFaceAnEndOfTheScan() {
        for (int speck : new int[] {29, 30}) {
            byte[] labels = new byte[3 * SIDE * SIDE];
            for (int v = 0; v < 100; v++) {
                labels[v % 10 + v / 10 * SIDE] = (byte) (v < 50 ? 1 : 0);
                labels[SIDE * SIDE + v % 10 + v / 10 * SIDE] = 1;
                labels[2 * SIDE * SIDE + v % 10 + v / 10 * SIDE] = (byte) (v < 50 ? 1 : 0);
            }
            Arrays.fill(labels, 15 * SIDE, 15 * SIDE + speck, (byte) 2);
            LabelGrid grid = LabelGrid.of(SIDE, SIDE, 3, labels, TO_MM);
            assertThat(EmptyLayers.beyond(grid, Extent.LABELS).slices()).isEqualTo(speck == 29 ? 5 : 4);
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
        LabelGrid padded = EmptyLayers.beyond(ball(1), Extent.FIELD);
        assertThat(EmptyLayers.beyond(padded, Extent.LABELS)).isSameAs(padded);
        LabelGrid empty = LabelGrid.of(SIDE, SIDE, SIDE, new byte[SIDE * SIDE * SIDE], TO_MM);
        assertThat(EmptyLayers.beyond(empty, Extent.LABELS)).isSameAs(empty);
        LabelVolume volume = new LabelVolume(ball(1), Map.of(1, "liver"), List.of("a note"));
        LabelVolume whole = volume.withEmptyLayers();
        assertThat(Arrays.equals(box(whole.grid()), box(padded))).isTrue();
        assertThat(whole.names()).isEqualTo(volume.names());
        assertThat(whole.notes()).isEqualTo(volume.notes());
        assertThat(whole.withEmptyLayers()).isSameAs(whole);
    }
}
