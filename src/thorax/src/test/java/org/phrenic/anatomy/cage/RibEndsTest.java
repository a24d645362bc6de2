package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.TriangleMesh;

class RibEndsTest {
    private static final double RADIUS = 100;
    private static final double THICKNESS = 5;
    /** End regions of 5 mm and cells of 2 to 4 mm: an end is known to about this. */
    private static final double END_MM = 5;

    @Test
    void endsOfATubeAreFound() {
        RibEnds ends = RibEnds.find(tube(0, 80), Side.RIGHT);
        // The arc runs from behind the middle (head) round the right side to the front.
        assertNear(ends.head(), 0, RADIUS, 0);
        assertNear(ends.anterior(), -RADIUS * Math.sin(2.4), RADIUS * Math.cos(2.4), 0);
        // Along the surface: between the inner and the outer edge of the arc
        assertThat(ends.lengthMm()).isBetween(2.4 * (RADIUS - THICKNESS) - END_MM, 2.4 * (RADIUS + THICKNESS));
    }

    @Test
    void patchesWithoutCommonVerticesAreOneRib() {
        TriangleMesh whole = tube(0, 80);
        TriangleMesh patches = joined(tube(0, 30), tube(34, 80));
        double[] head = RibEnds.find(patches, Side.RIGHT).head();
        double[] anterior = RibEnds.find(patches, Side.RIGHT).anterior();
        assertThat(head).containsExactly(RibEnds.find(whole, Side.RIGHT).head(), within(END_MM / 2));
        assertThat(anterior).containsExactly(RibEnds.find(whole, Side.RIGHT).anterior(), within(END_MM / 2));
    }

    @Test
    void mirroredRibHasMirroredEnds() {
        TriangleMesh right = tube(0, 80);
        double[] mirrored = right.positions().clone();
        for (int i = 0; i < mirrored.length; i += 3) {
            mirrored[i] = -mirrored[i];
        }
        RibEnds left = RibEnds.find(right.withPositions(mirrored), Side.LEFT);
        assertNear(left.head(), 0, RADIUS, 0);
        assertNear(left.anterior(), RADIUS * Math.sin(2.4), RADIUS * Math.cos(2.4), 0);
    }

    @Test
    void whatHasNoEndsIsRefused() {
        assertThatThrownBy(() -> RibEnds.find(new TriangleMesh(new double[0], new int[0]), Side.RIGHT))
                .hasMessage("rib: a mesh of 0 vertices without extent, expected the surface of a rib");
        assertThatThrownBy(() -> RibEnds.find(tube(0, 80), Side.MIDLINE))
                .hasMessage("rib: side MIDLINE, expected RIGHT or LEFT");
    }

    /**
     * Heads stand beside the spine, tips away from it; the raw surfaces of many patches give what the closed ones do.
     */
    @Test
    void endsOfRealRibsAreFoundOnBothKindsOfSurface() throws IOException {
        for (int level = 1; level <= 12; level++) {
            for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
                RibEnds closed = RibEnds.find(SharedRibs.rib("anatomy/male-thorax/watertight", level, side), side);
                RibEnds patches = RibEnds.find(SharedRibs.rib("anatomy/male-thorax", level, side), side);
                // Heads of ribs meet vertebral bodies some 40 mm wide.
                assertThat(side.sign() * closed.head()[0]).as("rib " + level).isBetween(12.0, 28.0);
                // The last rib is short and points backward from its head.
                assertThat(closed.head()[1] > closed.anterior()[1] || level == 12)
                        .as("rib " + level)
                        .isTrue();
                assertThat(patches.head()).as("rib " + level).containsExactly(closed.head(), within(END_MM));
                assertThat(patches.anterior()).as("rib " + level).containsExactly(closed.anterior(), within(END_MM));
            }
        }
    }

    private static void assertNear(double[] point, double x, double y, double z) {
        assertThat(point).containsExactly(new double[] {x, y, z}, within(END_MM));
    }

    /** Rings {@code first} to {@code last} of 80 along an arc of 2.4 rad. */
    private static TriangleMesh tube(int first, int last) {
        int sides = 8;
        int rings = last - first + 1;
        double[] positions = new double[3 * rings * sides];
        int[] triangles = new int[6 * (rings - 1) * sides];
        for (int r = 0; r < rings; r++) {
            double along = 2.4 * (first + r) / 80;
            for (int s = 0; s < sides; s++) {
                double around = 2 * Math.PI * s / sides;
                double radius = RADIUS + THICKNESS * Math.cos(around);
                int v = r * sides + s;
                positions[3 * v] = -radius * Math.sin(along);
                positions[3 * v + 1] = radius * Math.cos(along);
                positions[3 * v + 2] = THICKNESS * Math.sin(around);
                if (r > 0) {
                    int next = r * sides + (s + 1) % sides;
                    int[] two = {v - sides, v, next, v - sides, next, next - sides};
                    System.arraycopy(two, 0, triangles, 6 * ((r - 1) * sides + s), 6);
                }
            }
        }
        return new TriangleMesh(positions, triangles);
    }

    private static TriangleMesh joined(TriangleMesh a, TriangleMesh b) {
        double[] positions = new double[a.positions().length + b.positions().length];
        System.arraycopy(a.positions(), 0, positions, 0, a.positions().length);
        System.arraycopy(b.positions(), 0, positions, a.positions().length, b.positions().length);
        int[] triangles = new int[a.triangles().length + b.triangles().length];
        System.arraycopy(a.triangles(), 0, triangles, 0, a.triangles().length);
        for (int i = 0; i < b.triangles().length; i++) {
            triangles[a.triangles().length + i] = b.triangles()[i] + a.vertexCount();
        }
        return new TriangleMesh(positions, triangles);
    }
}
