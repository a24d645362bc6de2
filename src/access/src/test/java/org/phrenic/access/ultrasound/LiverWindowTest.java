package org.phrenic.access.ultrasound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/** The virtual man, and the same man in a file whose origin lies elsewhere. */
class LiverWindowTest {
    /** Search between the ribs, above and below the middle of the liver. */
    private static final double SEARCH_MM = 25;

    private static final double BELOW_MM = 20;
    /** Half the breadth of the costal margin that lies above a place. */
    private static final double STRIP_MM = 15;

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

    private static double[] boundsOf(StructureKind kind) {
        return Surface.bounds(moved(0).stream().filter(s -> s.kind() == kind).toList());
    }

    private static double distanceToRightRibs(double[] place) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        return MAN.structures().stream()
                .filter(s -> s.kind() == StructureKind.RIB && s.side() == Side.RIGHT)
                .mapToDouble(s -> {
                    new TriangleTree(s.mesh()).closest(place[0], place[1], place[2], hit);
                    return Math.sqrt(hit.distanceSquared);
                })
                .min()
                .orElseThrow();
    }

    @Test
    void theMidlineOfAVirtualBodyIsThatOfItsAxes() {
        assertThat(LiverWindow.SUBXIPHOID.placeOn(moved(0))[0]).isZero();
        assertThat(LiverWindow.RIGHT_SUBCOSTAL.placeOn(moved(0))[0]).isEqualTo(0.5 * boundsOf(StructureKind.LIVER)[0]);
    }

    @Test
    void betweenTheRibsIsOnTheRightSideNearTheHeightOfTheLiverWhereTheGapIsWidest() {
        double[] liver = boundsOf(StructureKind.LIVER);
        double[] place = LiverWindow.RIGHT_INTERCOSTAL.placeOn(moved(0));
        assertThat(place[0]).isLessThan(liver[0]);
        double middleY = 0.5 * (liver[1] + liver[4]);
        double middleZ = 0.5 * (liver[2] + liver[5]);
        assertThat(place[1]).isCloseTo(middleY, within(1e-9));
        assertThat(place[2]).isCloseTo(middleZ, within(SEARCH_MM));
        TriangleTree skin =
                new TriangleTree(MAN.structuresOf(StructureKind.SKIN).get(0).mesh());
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double widest = distanceToRightRibs(place);
        for (double dz = -SEARCH_MM; dz <= SEARCH_MM; dz += 5) {
            assertThat(skin.nearestAlongRay(-1000, middleY, middleZ + dz, 1, 0, 0, hit))
                    .isTrue();
            assertThat(distanceToRightRibs(new double[] {hit.x, hit.y, hit.z}))
                    .as("%.0f mm above the middle", dz)
                    .isLessThanOrEqualTo(widest);
        }
    }

    @Test
    void theWindowsInFrontLieTwoCentimetresBelowTheSternumAndTheCostalMargin() {
        double[] liver = boundsOf(StructureKind.LIVER);
        double[] xiphoid = LiverWindow.SUBXIPHOID.placeOn(moved(0));
        assertThat(xiphoid[1]).isLessThan(liver[1]);
        assertThat(xiphoid[2]).isCloseTo(boundsOf(StructureKind.STERNUM)[2] - BELOW_MM, within(1e-9));

        double[] subcostal = LiverWindow.RIGHT_SUBCOSTAL.placeOn(moved(0));
        assertThat(subcostal[1]).isLessThan(0.5 * (liver[1] + liver[4]));
        double[] cage = boundsOf(StructureKind.RIB);
        double margin = Double.POSITIVE_INFINITY;
        for (Surface s : moved(0)) {
            if (s.kind() == StructureKind.RIB || s.kind() == StructureKind.COSTAL_CARTILAGE) {
                for (int v = 0; v < s.rest().vertexCount(); v++) {
                    boolean above = Math.abs(s.rest().x(v) - subcostal[0]) < STRIP_MM
                            && s.rest().y(v) < 0.5 * (cage[1] + cage[4]);
                    margin = above ? Math.min(margin, s.rest().z(v)) : margin;
                }
            }
        }
        assertThat(subcostal[2]).isCloseTo(margin - BELOW_MM, within(1e-9));
    }
}
