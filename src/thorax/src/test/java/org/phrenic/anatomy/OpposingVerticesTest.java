package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.TriangleMesh;

class OpposingVerticesTest {
    private static final double THICKNESS_MM = 3;
    private static final double REACH_MM = 20;

    private static Diaphragm dome;
    private static OpposingVertices across;

    @BeforeAll
    static void make() {
        dome = Diaphragm.withTrefoilTendon(DomeSheet.of(130, 90, 110, THICKNESS_MM, 20, 0));
        across = OpposingVertices.of(dome, REACH_MM);
    }

    private static int[] uses(List<OpposingVertices.Pair> pairs, int vertices) {
        int[] used = new int[vertices];
        for (OpposingVertices.Pair p : pairs) {
            used[p.a()]++;
            used[p.b()]++;
        }
        return used;
    }

    private static double distance(TriangleMesh m, OpposingVertices.Pair p) {
        return Math.sqrt(Math.pow(m.x(p.a()) - m.x(p.b()), 2)
                + Math.pow(m.y(p.a()) - m.y(p.b()), 2)
                + Math.pow(m.z(p.a()) - m.z(p.b()), 2));
    }

    @Test
    void pairsLieOnOpposingFacesWithinReachAndAreListedOnce() {
        List<OpposingVertices.Pair> pairs = across.nearestPairs(3);
        assertThat(pairs).doesNotHaveDuplicates().allSatisfy(p -> {
            assertThat(p.a()).isLessThan(p.b());
            assertThat(dome.isThoracic(p.a())).isNotEqualTo(dome.isThoracic(p.b()));
            assertThat(distance(dome.sheet(), p)).isLessThanOrEqualTo(REACH_MM);
        });
    }

    @Test
    void theNearestOpposingVertexIsTheOneStraightAcross() {
        int half = dome.sheet().vertexCount() / 2;
        long straight = across.nearestPairs(1).stream()
                .filter(p -> p.b() == p.a() + half)
                .count();
        // All but the rim, where the faces meet at an edge and their normals hardly oppose.
        assertThat(straight).isGreaterThan((long) (0.85 * half));
        assertThat(coverage(dome.sheet(), across)).isGreaterThan(0.95);
    }

    @Test
    void noVertexIsInMoreLinksThanAllowed() {
        for (int most = 0; most <= 3; most++) {
            List<OpposingVertices.Pair> links = across.greedyMatching(dome::isTendon, most);
            int[] used = uses(links, dome.sheet().vertexCount());
            for (int i = 0; i < used.length; i++) {
                assertThat(used[i]).isLessThanOrEqualTo(dome.isTendon(i) ? most : 0);
            }
            assertThat(links.isEmpty()).isEqualTo(most == 0);
        }
    }

    @Test
    void oneLinkAVertexTiesTheTwoFacesOfTheTendonByTheThicknessOfTheSheet() {
        List<OpposingVertices.Pair> links = across.greedyMatching(dome::isTendon, 1);
        double mean = links.stream()
                .mapToDouble(p -> distance(dome.sheet(), p))
                .average()
                .orElseThrow();
        assertThat(mean).isCloseTo(THICKNESS_MM, within(0.1));
        long tendon = java.util.stream.IntStream.range(0, dome.sheet().vertexCount())
                .filter(dome::isTendon)
                .count();
        assertThat(2 * links.size()).isGreaterThan((int) (0.9 * tendon));
    }

    @Test
    void theVirtualSheetHasAnOpposingVertexNearlyEverywhere() {
        Diaphragm male = Diaphragm.withTrefoilTendon(VirtualThorax.ofPreset("adult-male", Resolution.LOW)
                .find("diaphragm")
                .orElseThrow()
                .mesh());
        assertThat(coverage(male.sheet(), OpposingVertices.of(male, REACH_MM))).isGreaterThan(0.9);
    }

    @Test
    void aClosedBodyIsBracedAcrossItself() {
        TriangleMesh box = DomeSheet.of(20, 20, 20, 6, 6, 0);
        List<OpposingVertices.Pair> pairs = OpposingVertices.of(box, 10).nearestPairs(2);
        assertThat(pairs).isNotEmpty().allSatisfy(p -> assertThat(distance(box, p))
                .isLessThanOrEqualTo(10));
    }

    /**
     * A strut resists a change of thickness. It joins the two sides of a wedge; it joins no sides that meet nearly at a
     * right angle or at more.
     */
    @ParameterizedTest
    @CsvSource({"10, true", "45, true", "70, true", "80, false", "90, false", "120, false"})
    void theSidesOfAWedgeOpposeAndThoseOfACornerDoNot(double degrees, boolean opposing) {
        assertThat(!OpposingVertices.of(wedge(degrees), REACH_MM)
                        .nearestPairs(1)
                        .isEmpty())
                .isEqualTo(opposing);
    }

    /** Two flat sides that would meet at the y axis at an angle, each 5 to 7 mm from it; they face outward. */
    private static TriangleMesh wedge(double degrees) {
        double[] p = new double[24];
        for (int v = 0; v < 8; v++) {
            double angle = v < 4 ? 0 : Math.toRadians(degrees);
            double along = v % 2 == 0 ? 5 : 7;
            p[3 * v] = along * Math.cos(angle);
            p[3 * v + 1] = v % 4 < 2 ? 0 : 2;
            p[3 * v + 2] = along * Math.sin(angle);
        }
        return new TriangleMesh(p, new int[] {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6});
    }

    /** Share of vertices that have an opposing one in reach. */
    private static double coverage(TriangleMesh sheet, OpposingVertices across) {
        long covered = across.nearestPairs(1).stream()
                .flatMapToInt(pair -> IntStream.of(pair.a(), pair.b()))
                .distinct()
                .count();
        return covered / (double) sheet.vertexCount();
    }
}
