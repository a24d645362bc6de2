package org.phrenic.access.ultrasound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.simulation.observe.Surface;

/** The virtual man, and the same man in a file whose origin lies elsewhere. */
class LiverWindowTest {
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    private static List<Surface> moved(double xMm) {
        return MAN.structures().stream().map(s -> moved(s, xMm)).toList();
    }

    private static Surface moved(Structure s, double xMm) {
        double[] positions = s.mesh().positions().clone();
        for (int i = 0; i < positions.length; i += 3) {
            positions[i] += xMm;
        }
        return new Surface(
                s.name(),
                s.kind(),
                s.level(),
                s.side(),
                s.mesh().withPositions(positions),
                Surface.Motion.STILL,
                new boolean[0]);
    }

    @ParameterizedTest
    @EnumSource
    void theProbeGoesWithABodyWhoseOriginLiesElsewhere(LiverWindow window) {
        double[] place = window.placeOn(moved(0));
        for (double x : new double[] {200, -40, -295}) {
            double[] expected = {place[0] + x, place[1], place[2]};
            assertThat(window.placeOn(moved(x))).containsExactly(expected, within(1e-6));
        }
    }

    @Test
    void theMidlineOfAVirtualBodyIsThatOfItsAxes() {
        double liver = MAN.structures().stream()
                .filter(s -> s.kind() == StructureKind.LIVER)
                .mapToDouble(s -> s.mesh().bounds()[0])
                .min()
                .orElseThrow();
        assertThat(LiverWindow.SUBXIPHOID.placeOn(moved(0))[0]).isZero();
        assertThat(LiverWindow.RIGHT_SUBCOSTAL.placeOn(moved(0))[0]).isEqualTo(0.5 * liver);
    }
}
