package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.patient.registration.DiaphragmaticSurface;

/** A lung whole, and in two lobes that an oblique fissure divides and that are open there. */
class LungBaseVerticesTest {
    private static final TriangleMesh LUNG = VirtualThorax.ofPreset("adult-male", Resolution.LOW)
            .find(StructureKind.LUNG, 0, Side.RIGHT)
            .orElseThrow()
            .mesh();

    /** The part of the lung above or below a plane that falls to the front, so that both lobes reach the base. */
    private static TriangleMesh lobe(boolean upper) {
        double[] centre = LUNG.centre();
        IntList corners = new IntList();
        for (int i = 0; i < LUNG.triangles().length; i += 3) {
            double[] middle = MeshMeasure.centroid(LUNG, i / 3);
            boolean above = middle[2] - centre[2] > 1.5 * (middle[1] - centre[1]);
            for (int c = i; c < i + 3 && above == upper; c++) {
                corners.add(LUNG.triangles()[c]);
            }
        }
        return MeshRepair.clean(new TriangleMesh(LUNG.positions(), corners.toArray()))
                .mesh();
    }

    private static TriangleMesh turned(TriangleMesh mesh) {
        int[] t = mesh.triangles().clone();
        for (int i = 0; i < t.length; i += 3) {
            t[i] = mesh.triangles()[i + 1];
            t[i + 1] = mesh.triangles()[i];
        }
        return new TriangleMesh(mesh.positions(), t);
    }

    @Test
    void lobesThatFaceInwardHaveTheSameBase() {
        TriangleMesh both = MeshMerge.merge(List.of(lobe(true), lobe(false)));
        assertThat(LungBaseVertices.of(turned(both))).containsExactly(LungBaseVertices.of(both));
    }

    @Test
    void theWallOfACavityIsNoLobe() {
        double[] c = LUNG.centre();
        TriangleMesh cavity = turned(Shapes.moved(Shapes.sphere(30, 3), c[0], c[1], c[2]));
        assertThat(MeshMeasure.area(cavity)).isGreaterThan(0.08 * MeshMeasure.area(LUNG));
        boolean[] mask = LungBaseVertices.of(MeshMerge.merge(List.of(LUNG, cavity)));
        assertThat(Arrays.copyOf(mask, LUNG.vertexCount())).containsExactly(LungBaseVertices.of(LUNG));
    }

    private static double area(TriangleMesh mesh, boolean[] mask) {
        double[] areas = MeshMeasure.vertexAreas(mesh);
        double sum = 0;
        for (int v = 0; v < mask.length; v++) {
            sum += mask[v] ? areas[v] : 0;
        }
        return sum;
    }

    @Test
    void aLungOfOnePieceHasThoseOfItsDiaphragmaticSurface() {
        assertThat(LungBaseVertices.of(LUNG)).containsExactly(DiaphragmaticSurface.vertexMask(LUNG));
    }

    @Test
    void aLungInLobesHasTheBaseOfTheWholeLungOnBoth() {
        List<TriangleMesh> lobes = List.of(lobe(true), lobe(false));
        TriangleMesh both = MeshMerge.merge(lobes);
        boolean[] mask = LungBaseVertices.of(both);
        double whole = area(LUNG, LungBaseVertices.of(LUNG));
        assertThat(area(both, mask)).isCloseTo(whole, within(0.15 * whole));
        int first = lobes.get(0).vertexCount();
        assertThat(area(lobes.get(0), Arrays.copyOf(mask, first))).isGreaterThan(0.1 * whole);
        assertThat(area(lobes.get(1), Arrays.copyOfRange(mask, first, mask.length)))
                .isGreaterThan(0.1 * whole);
        SurfaceDistance base = new SurfaceDistance(DiaphragmaticSurface.of(LUNG));
        List<Double> off = new ArrayList<>();
        for (int v = 0; v < mask.length; v++) {
            if (mask[v]) {
                off.add(base.unsignedDistance(both.x(v), both.y(v), both.z(v)));
            }
        }
        assertThat(off.stream().filter(d -> d > 10)).hasSizeLessThan(off.size() / 10);
    }
}
