package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;

/** The outline of the target over a picture. */
class NeedleMarkersTest {
    private static final int SIDE = 400;
    private static final double RADIUS_MM = 10;
    /** Half of the line and of its light edge, pixels. */
    private static final double LINE = 2;

    private static final double[] BOX = {-150, -100, -200, 150, 100, 200};

    private static NeedleState target(double[] at) {
        double[] origin = new double[3];
        return new NeedleState(
                1,
                RespiratoryPhase.PAUSE,
                at,
                RADIUS_MM,
                Optional.empty(),
                false,
                origin,
                origin,
                0,
                0,
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

    /** Width of what the outlines draw, pixels. */
    private static double width(NeedleState state, Camera camera) {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = picture.createGraphics();
        new NeedleMarkers(state, PathAdvice.Level.FREE, true).drawOutlines(g, camera, SIDE, SIDE);
        g.dispose();
        int[] columns = IntStream.range(0, SIDE)
                .filter(x -> IntStream.range(0, SIDE).anyMatch(y -> picture.getRGB(x, y) != 0))
                .toArray();
        return columns[columns.length - 1] + 1.0 - columns[0];
    }

    @ParameterizedTest
    @CsvSource({"-100, false", "0, false", "100, false", "-100, true", "100, true"})
    void theOutlineIsAsLargeAsTheTargetIsSeen(double behindMm, boolean parallel) {
        double[] at = {0, behindMm, 0};
        Camera camera =
                Camera.of(AnatomicalView.ANTERIOR, BOX).withProjection(parallel).withHeight(200);
        Vector3d right = camera.right().mul(RADIUS_MM);
        double[] middle = new double[2];
        double[] side = new double[2];
        camera.project(at[0], at[1], at[2], SIDE, SIDE, middle);
        camera.project(at[0] + right.x, at[1] + right.y, at[2] + right.z, SIDE, SIDE, side);
        double seen = 2 * Math.hypot(side[0] - middle[0], side[1] - middle[1]);
        assertThat(width(target(at), camera)).isCloseTo(seen + 2 * LINE, within(1.5));
    }
}
