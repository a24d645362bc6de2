package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;

/** Outlines of target, needle and path over a picture. */
class NeedleMarkersTest {
    private static final int SIDE = 400;
    private static final double RADIUS_MM = 10;
    /** Half of the line and of its light edge, pixels. */
    private static final double LINE = 2;

    private static final double[] BOX = {-150, -100, -200, 150, 100, 200};

    /** Far from the target, across the picture: hub, entry, tip and the end of the path, mm along x. */
    private static final double[] NEEDLE_X = {-70, -40, -10, 30};

    private static final double NEEDLE_Z = 45;

    private static NeedleState state(double[] target, Optional<double[]> entry) {
        return new NeedleState(
                1,
                RespiratoryPhase.PAUSE,
                target,
                RADIUS_MM,
                entry,
                entry.isPresent(),
                onNeedle(NEEDLE_X[0]),
                onNeedle(NEEDLE_X[2]),
                NEEDLE_X[2] - NEEDLE_X[1],
                NEEDLE_X[3] - NEEDLE_X[1],
                false,
                Optional.empty(),
                List.of(),
                0,
                "",
                List.of(),
                0,
                new NeedleAngles(0, 0),
                Optional.empty(),
                NeedleLoad.NONE);
    }

    private static double[] onNeedle(double x) {
        return new double[] {x, 0, NEEDLE_Z};
    }

    private static BufferedImage outlines(NeedleState state, Camera camera) {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = picture.createGraphics();
        new NeedleMarkers(state, PathAdvice.Level.FREE, true).drawOutlines(g, camera, SIDE, SIDE);
        g.dispose();
        return picture;
    }

    /** First and last column, then first and last row, that a picture has something in, between two rows. */
    private static int[] painted(BufferedImage picture, int fromRow, int toRow) {
        int[] columns = IntStream.range(0, SIDE)
                .filter(x -> IntStream.range(fromRow, toRow).anyMatch(y -> picture.getRGB(x, y) != 0))
                .toArray();
        int[] rows = IntStream.range(fromRow, toRow)
                .filter(y -> IntStream.range(0, SIDE).anyMatch(x -> picture.getRGB(x, y) != 0))
                .toArray();
        return new int[] {columns[0], columns[columns.length - 1], rows[0], rows[rows.length - 1]};
    }

    @ParameterizedTest
    @CsvSource({"-100, false", "0, false", "100, false", "-100, true", "100, true"})
    void theOutlineIsAsLargeAsTheTargetIsSeenAndWhereItIsSeen(double behindMm, boolean parallel) {
        double[] at = {40, behindMm, -30};
        Camera camera =
                Camera.of(AnatomicalView.ANTERIOR, BOX).withProjection(parallel).withHeight(200);
        Vector3d right = camera.right().mul(RADIUS_MM);
        double[] middle = new double[2];
        double[] side = new double[2];
        camera.project(at[0], at[1], at[2], SIDE, SIDE, middle);
        camera.project(at[0] + right.x, at[1] + right.y, at[2] + right.z, SIDE, SIDE, side);
        double seen = 2 * Math.hypot(side[0] - middle[0], side[1] - middle[1]);
        int[] painted = painted(outlines(state(at, Optional.empty()), camera), 0, SIDE);
        assertThat(painted[1] + 1.0 - painted[0]).isCloseTo(seen + 2 * LINE, within(1.5));
        assertThat((painted[0] + painted[1] + 1) / 2.0).isCloseTo(middle[0], within(1.0));
        assertThat((painted[2] + painted[3] + 1) / 2.0).isCloseTo(middle[1], within(1.0));
    }

    /** The map has ambers as bright as the ring. */
    @Test
    void theOutlineHasADarkRim() {
        Camera camera =
                Camera.of(AnatomicalView.ANTERIOR, BOX).withProjection(true).withHeight(200);
        BufferedImage ring = outlines(state(new double[] {0, 0, 0}, Optional.empty()), camera);
        int[] painted = painted(ring, 0, SIDE);
        int rim = ring.getRGB(painted[0], SIDE / 2);
        int line = ring.getRGB(painted[0] + 2, SIDE / 2);
        assertThat(rim >> 16 & 0xff).isLessThan(0x80).isLessThan(line >> 16 & 0xff);
    }

    /** From its hub to its tip the needle, from the entry to the end the path, which is dashed. */
    @Test
    void needleAndPathAreDrawnFromEndToEnd() {
        Camera camera =
                Camera.of(AnatomicalView.ANTERIOR, BOX).withProjection(true).withHeight(200);
        double[][] seen = new double[NEEDLE_X.length][2];
        for (int i = 0; i < seen.length; i++) {
            camera.project(NEEDLE_X[i], 0, NEEDLE_Z, SIDE, SIDE, seen[i]);
        }
        int row = (int) seen[0][1];
        double[] target = {0, 0, -60};
        BufferedImage picture = outlines(state(target, Optional.of(onNeedle(NEEDLE_X[1]))), camera);
        int[] painted = painted(picture, row - 10, row + 10);
        assertThat(painted[0]).isCloseTo((int) seen[0][0], within(2));
        // The last dash begins within a gap of the end.
        assertThat((double) painted[1]).isBetween(seen[3][0] - 6, seen[3][0] + 1);
        assertThat((painted[2] + painted[3] + 1) / 2.0).isCloseTo(seen[0][1], within(1.0));
        int[] needle = columns(picture, row, 0x1f4e79);
        assertThat(needle[0]).isCloseTo((int) seen[0][0], within(2));
        assertThat(needle[needle.length - 1]).isCloseTo((int) seen[2][0], within(2));
        int[] path = columns(picture, row, NeedleMarkers.rgb(PathAdvice.Level.FREE));
        assertThat(path).as("beyond the tip").hasSizeGreaterThan(20);
        assertThat(path[0]).isCloseTo((int) seen[2][0], within(6));
        assertThat(columns(outlines(state(target, Optional.empty()), camera), row, 0x1f4e79))
                .as("without an entry")
                .isEmpty();
    }

    private static int[] columns(BufferedImage picture, int row, int rgb) {
        return IntStream.range(0, SIDE)
                .filter(x -> picture.getRGB(x, row) == (0xff000000 | rgb))
                .toArray();
    }
}
