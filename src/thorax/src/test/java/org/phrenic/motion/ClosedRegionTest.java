package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

class ClosedRegionTest {
    private static final double RADIUS_MM = 30;
    /** Radius of a hole that faces along the columns, whose lines meet the sphere once. */
    private static final double HOLE_MM = 20;

    private static final double PER_MM = 0.02;

    private static boolean isInHole(TriangleMesh sphere, int vertex) {
        return sphere.x(vertex) > 0 && Math.hypot(sphere.y(vertex), sphere.z(vertex)) < HOLE_MM;
    }

    /** The displacement y z along x is harmonic, and the same along the columns, behind the hole, too. */
    @Test
    void theInsideBehindAHoleIsExtendedFromTheSurfaceAsAnyOther() {
        TriangleMesh sphere = Shapes.sphere(RADIUS_MM, 4);
        int[] t = sphere.triangles();
        TriangleMesh open = new TriangleMesh(
                sphere.positions(),
                IntStream.range(0, t.length)
                        .filter(i -> !IntStream.range(i / 3 * 3, i / 3 * 3 + 3).allMatch(c -> isInHole(sphere, t[c])))
                        .map(i -> t[i])
                        .toArray());
        ClosedRegion region = new ClosedRegion(
                new Surface(
                        "organ", StructureKind.ORGAN, 0, Side.MIDLINE, open, Surface.Motion.DEFORMING, new boolean[0]),
                false);
        double[] moved = sphere.positions().clone();
        for (int k = 0; k < moved.length; k += 3) {
            moved[k] += PER_MM * moved[k + 1] * moved[k + 2];
        }
        region.update(moved);
        double[] u = new double[3];
        region.lattice().at(0, 10, 10, u);
        assertThat(u[0]).isCloseTo(PER_MM * 100, within(0.2));
    }
}
