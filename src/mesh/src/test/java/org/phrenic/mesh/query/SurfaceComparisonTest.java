package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class SurfaceComparisonTest {
    private static final double ROUNDING = 1e-9;
    /** Chords of a sphere of 2562 vertices lie up to 0.13 % of the radius below it. */
    private static final double CHORD = 0.03;

    @Test
    void concentricSpheresAreAsFarApartAsTheirRadii() {
        SurfaceComparison c = SurfaceComparison.of(Shapes.sphere(20, 4), Shapes.sphere(17, 4));
        for (SurfaceComparison.DirectedDistances way : new SurfaceComparison.DirectedDistances[] {c.aToB(), c.bToA()}) {
            for (DistanceSummary d : new DistanceSummary[] {way.perVertex(), way.byArea()}) {
                assertThat(d.mean()).isCloseTo(3, within(CHORD));
                assertThat(d.rms()).isCloseTo(3, within(CHORD));
                assertThat(d.median()).isCloseTo(3, within(CHORD));
                assertThat(d.percentile95()).isCloseTo(3, within(CHORD));
                assertThat(d.deviation()).isLessThan(CHORD);
            }
        }
        assertThat(c.aToB().signedMean()).isCloseTo(3, within(CHORD));
        assertThat(c.bToA().signedMean()).isCloseTo(-3, within(CHORD));
        assertThat(c.hausdorff()).isCloseTo(3, within(CHORD));
    }

    @Test
    void theFarEndOfTheLongerBoxIsSeenFromOneSideAlone() {
        TriangleMesh longer = Shapes.box(30, 10, 10);
        TriangleMesh shorter = Shapes.box(20, 10, 10);
        SurfaceComparison c = SurfaceComparison.of(longer, shorter);
        assertThat(c.aToB().perVertex().maximum()).isCloseTo(10, within(ROUNDING));
        assertThat(c.bToA().perVertex().maximum()).isCloseTo(0, within(ROUNDING));
        assertThat(c.hausdorff()).isCloseTo(10, within(ROUNDING));
        assertThat(SurfaceComparison.summaryByArea(longer, shorter)).isEqualTo(c.byArea());
    }

    /**
     * Of a tetrahedron with a corner 30 mm out, that corner lies 18 mm outside a box and the others 12 mm inside. Its
     * faces have 150, 150, 50 and 50 sqrt 19 mm2, and all but that of 50 mm2 meet in it.
     */
    @Test
    void distancesAreWeightedByTheAreaOfTheVertices() {
        TriangleMesh tetrahedron = new TriangleMesh(
                new double[] {0, 0, 0, 30, 0, 0, 0, 10, 0, 0, 0, 10}, new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        TriangleMesh box = Shapes.moved(Shapes.box(100, 100, 100), -88, -50, -50);
        SurfaceComparison.DirectedDistances out =
                SurfaceComparison.of(tetrahedron, box).aToB();
        double slanted = 50 * Math.sqrt(19);
        double share = (300 + slanted) / (3 * (350 + slanted));
        assertThat(out.perVertex().mean()).isCloseTo((18 + 3 * 12) / 4.0, within(ROUNDING));
        assertThat(out.byArea().mean()).isCloseTo(18 * share + 12 * (1 - share), within(ROUNDING));
        assertThat(out.signedMean()).isCloseTo(18 * share - 12 * (1 - share), within(ROUNDING));
    }

    @Test
    void aShiftAlongAPlaneShowsInCorrespondingVerticesAlone() {
        TriangleMesh sheet = Shapes.sheet(100, 100, 11, 11);
        SurfaceComparison c = SurfaceComparison.of(sheet, Shapes.moved(sheet, 4, 3, 0));
        assertThat(c.corresponding().orElseThrow().mean()).isCloseTo(5, within(ROUNDING));
        assertThat(c.aToB().byArea().median()).isCloseTo(0, within(ROUNDING));
        assertThat(c.aToB().signed()).isFalse();
        assertThat(c.aToB().signedMean()).isNaN();
        assertThat(SurfaceComparison.of(sheet, Shapes.sheet(100, 100, 12, 12)).corresponding())
                .isEmpty();
    }

    @Test
    void weightedFiguresAreThoseOfRepeatedValues() {
        DistanceSummary weighted = DistanceSummary.of(new double[] {4, -1, 2, 7}, new double[] {2, 3, 4, 0});
        DistanceSummary repeated = DistanceSummary.of(new double[] {4, 4, 1, 1, 1, 2, 2, 2, 2});
        assertThat(weighted.points()).isEqualTo(3);
        assertThat(weighted.mean()).isCloseTo(repeated.mean(), within(ROUNDING));
        assertThat(weighted.deviation()).isCloseTo(repeated.deviation(), within(ROUNDING));
        assertThat(weighted.rms()).isCloseTo(repeated.rms(), within(ROUNDING));
        assertThat(weighted.median()).isEqualTo(2);
        assertThat(weighted.percentile95()).isEqualTo(4);
        assertThat(weighted.maximum()).isEqualTo(4);
        double spread = Math.sqrt(weighted.rms() * weighted.rms() - weighted.mean() * weighted.mean());
        assertThat(weighted.deviation()).isCloseTo(spread, within(ROUNDING));
    }

    @Test
    void aVertexThatNoTriangleUsesCountsNowhere() {
        TriangleMesh box = Shapes.box(10, 10, 10);
        double[] p = Arrays.copyOf(box.positions(), box.positions().length + 3);
        p[p.length - 1] = 1000;
        SurfaceComparison c = SurfaceComparison.of(new TriangleMesh(p, box.triangles()), box);
        assertThat(c.aToB().perVertex().points()).isEqualTo(8);
        assertThat(c.hausdorff()).isZero();
        assertThat(c.aToB().distances()[8]).isGreaterThan(900);
    }

    @Test
    void sharesOfAHistogramAddUpToOneAndLieWhereTheDistancesDo() {
        DistanceHistogram h = DistanceHistogram.of(new double[] {0, 0.5, -1, 2, 4}, new double[] {1, 1, 2, 0, 4}, 4);
        assertThat(h.edgesMm()).containsExactly(0, 1, 2, 3, 4);
        assertThat(h.shares()).containsExactly(0.25, 0.25, 0, 0.5);
        DistanceHistogram none = DistanceHistogram.of(new double[] {0, 0}, new double[] {1, 1}, 3);
        assertThat(none.shares()).containsExactly(1, 0, 0);
    }

    @Test
    void nothingIsComparedWithASurfaceWithoutTriangles() {
        TriangleMesh empty = new TriangleMesh(new double[3], new int[0]);
        assertThatThrownBy(() -> SurfaceComparison.of(Shapes.box(1, 1, 1), empty))
                .hasMessageContaining("expected surfaces with triangles");
    }
}
