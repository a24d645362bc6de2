package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.scene.camera.Camera;

/** The side on which needles go in is seen whole. */
class EntryViewTest {
    private static final double[] BODY = {-190, -130, 0, 180, 120, 420};

    /** Views of windows of 1920 x 1080, 1280 x 800 and 1024 x 768, and one that is narrow. */
    @ParameterizedTest
    @CsvSource({"1100, 900", "540, 640", "300, 600", "260, 610"})
    void theWholeBodyIsInTheView(int width, int height) {
        Camera camera = EntryView.camera(BODY, width, height);
        assertThat(camera.azimuthDeg()).isNegative();
        double[] xy = new double[2];
        for (int corner = 0; corner < 8; corner++) {
            double x = BODY[(corner & 1) == 0 ? 0 : 3];
            double y = BODY[(corner & 2) == 0 ? 1 : 4];
            double z = BODY[(corner & 4) == 0 ? 2 : 5];
            assertThat(camera.project(x, y, z, width, height, xy)).isTrue();
            assertThat(xy[0]).isBetween(0.0, (double) width);
            assertThat(xy[1]).isBetween(0.0, (double) height);
        }
    }
}
