package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class MeshRepairTest {
    private static final double ROUNDING = 1e-9;

    @Test
    void aSoupWeldsBackToTheSurfaceItWasCutFrom() {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        MeshRepair.Result result = MeshRepair.weld(Shapes.soup(sphere), 0);
        assertThat(result.mesh().vertexCount()).isEqualTo(sphere.vertexCount());
        assertThat(result.report().verticesWelded()).isEqualTo(3 * sphere.triangleCount() - sphere.vertexCount());
        assertThat(new MeshTopology(result.mesh()).isClosed()).isTrue();
    }

    @Property(tries = 20, seed = "1")
    void verticesNearerThanTheToleranceBecomeOne(@ForAll @IntRange(min = 0, max = 1000) int seed) {
        Random random = new Random(seed);
        TriangleMesh soup = Shapes.soup(Shapes.sphere(10, 2));
        double[] p = soup.positions().clone();
        for (int i = 0; i < p.length; i++) {
            // Corners of one vertex lie within 2 sqrt(3) * 0.01 = 0.035 mm, vertices apart by more than 2 mm.
            p[i] += 0.01 * (2 * random.nextDouble() - 1);
        }
        assertThat(MeshRepair.weld(soup.withPositions(p), 0.05).mesh().vertexCount())
                .isEqualTo(162);
    }

    /**
     * Some files write 1e30 for a missing value; cells of the grid are numbered far beyond the range of a long there.
     */
    @ParameterizedTest
    @ValueSource(doubles = {3.7e16, 1e30, -1e30, 1e300, Double.MAX_VALUE})
    void aCoordinateFarFromAllOthersStaysAVertexOfItsOwn(double far) {
        TriangleMesh soup = Shapes.soup(Shapes.box(1, 2, 3));
        double[] p = Arrays.copyOf(soup.positions(), soup.positions().length + 9);
        int first = soup.vertexCount();
        p[3 * first] = far;
        p[3 * first + 4] = far;
        p[3 * first + 6] = far;
        int[] t = Arrays.copyOf(soup.triangles(), soup.triangles().length + 3);
        Arrays.setAll(t, i -> i < t.length - 3 ? t[i] : first + i - t.length + 3);
        assertThat(MeshRepair.weld(new TriangleMesh(p, t), 1e-3).mesh().vertexCount())
                .isEqualTo(8 + 2);
    }

    @Test
    void degenerateDuplicateAndUnusedGoAndAreCounted() {
        double[] p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 9, 9, 9};
        int[] t = {0, 1, 2, 0, 0, 1, 0, 1, 3, 2, 0, 1, 1, 0, 2};
        MeshRepair.Result result = MeshRepair.clean(new TriangleMesh(p, t));
        assertThat(result.mesh().triangles()).containsExactly(0, 1, 2);
        assertThat(result.mesh().vertexCount()).isEqualTo(3);
        assertThat(result.report()).isEqualTo(new MeshRepair.Report(0, 2, 2, 2, 0));
        assertThat(result.report())
                .hasToString("Repaired: 2 degenerate triangles removed, 2 duplicate triangles removed,"
                        + " 2 unused vertices removed.");
    }

    @Property(tries = 20, seed = "1")
    void scrambledSphereFacesOutwardAgain(@ForAll @IntRange(min = 0, max = 1000) int seed) {
        TriangleMesh sphere = Shapes.sphere(10, 2);
        int[] t = sphere.triangles().clone();
        Random random = new Random(seed);
        int scrambled = 0;
        for (int i = 0; i < t.length; i += 3) {
            if (random.nextBoolean()) {
                int b = t[i + 1];
                t[i + 1] = t[i + 2];
                t[i + 2] = b;
                scrambled++;
            }
        }
        MeshRepair.Result result = MeshRepair.orient(new TriangleMesh(sphere.positions(), t));
        assertThat(MeshMeasure.signedVolume(result.mesh())).isCloseTo(MeshMeasure.signedVolume(sphere), within(1e-6));
        assertThat(result.report().trianglesFlipped()).isEqualTo(scrambled);
    }

    /**
     * A shell within a shell bounds a cavity, a third one a part within the cavity; beside each other all are parts.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theShellOfACavityFacesInwardWhicheverWayItCame(boolean turned) {
        TriangleMesh outer = Shapes.box(10, 10, 10);
        TriangleMesh cavity = turned(Shapes.moved(Shapes.box(8, 8, 8), 1, 1, 1));
        TriangleMesh part = Shapes.moved(Shapes.box(2, 2, 2), 4, 4, 4);
        TriangleMesh nested = Shapes.join(Shapes.join(part, cavity), Shapes.moved(outer, 200, 0, 0));
        TriangleMesh mesh = Shapes.join(nested, outer);
        MeshRepair.Result result = MeshRepair.repair(turned ? turned(mesh) : mesh, 1e-3);
        assertThat(MeshMeasure.signedVolume(result.mesh())).isCloseTo(2 * 1000 - 512 + 8, within(1e-6));
        assertThat(result.report().trianglesFlipped()).isEqualTo(turned ? mesh.triangleCount() : 0);
    }

    private static TriangleMesh turned(TriangleMesh mesh) {
        int[] t = mesh.triangles().clone();
        for (int i = 0; i < t.length; i += 3) {
            int b = t[i + 1];
            t[i + 1] = t[i + 2];
            t[i + 2] = b;
        }
        return new TriangleMesh(mesh.positions(), t);
    }

    @Test
    void anOpenSheetKeepsTheSideMostOfItShowed() {
        TriangleMesh sheet = Shapes.sheet(3, 3, 4, 4);
        int[] t = sheet.triangles().clone();
        int b = t[1];
        t[1] = t[2];
        t[2] = b;
        MeshRepair.Result result = MeshRepair.orient(new TriangleMesh(sheet.positions(), t));
        assertThat(result.report().trianglesFlipped()).isEqualTo(1);
        assertThat(result.mesh().triangles()).containsExactly(sheet.triangles());
    }

    @Test
    void patchesRoundedEachForItselfCloseAlongTheirSeam() {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        TriangleMesh patches = Shapes.join(cap(sphere, 1), Shapes.moved(cap(sphere, -1), 0.004, -0.003, 0.005));
        assertThat(new MeshTopology(MeshRepair.repair(patches, 1e-3).mesh()).isClosed())
                .isFalse();
        MeshRepair.Result closed = MeshRepair.repair(patches, 1e-3, 0.05);
        assertThat(closed.mesh().vertexCount()).isEqualTo(sphere.vertexCount());
        assertThat(closed.mesh().triangleCount()).isEqualTo(sphere.triangleCount());
        assertThat(new MeshTopology(closed.mesh()).isClosed()).isTrue();
        // The lower half is off by 0.007 mm over a disc of 314 mm2: less than 3 mm3 of 4,100.
        assertThat(MeshMeasure.signedVolume(closed.mesh())).isCloseTo(MeshMeasure.signedVolume(sphere), within(3.0));
    }

    @Test
    void detailFinerThanASeamStaysWhereNoEdgeIsOpen() {
        TriangleMesh tiny = Shapes.sphere(0.05, 2);
        assertThat(MeshRepair.repair(tiny, 1e-3, 0.05).report()).hasToString("Nothing to repair.");
    }

    /**
     * The triangles of a sphere whose centre lies on one side of the equator; those whose centre is on it are of the
     * upper side.
     */
    private static TriangleMesh cap(TriangleMesh sphere, int side) {
        int[] t = sphere.triangles();
        int[] kept = java.util.stream.IntStream.range(0, t.length)
                .filter(i ->
                        side * (1e-6 + sphere.z(t[i - i % 3]) + sphere.z(t[i - i % 3 + 1]) + sphere.z(t[i - i % 3 + 2]))
                                > 0)
                .map(i -> t[i])
                .toArray();
        return MeshRepair.clean(new TriangleMesh(sphere.positions(), kept)).mesh();
    }

    @Test
    void componentsComeApartInOrder() {
        TriangleMesh both = Shapes.join(Shapes.box(1, 1, 1), Shapes.moved(Shapes.sphere(1, 1), 5, 0, 0));
        List<TriangleMesh> parts = ConnectedComponents.of(both);
        assertThat(parts).extracting(TriangleMesh::vertexCount).containsExactly(8, 42);
        assertThat(MeshMeasure.signedVolume(parts.get(0))).isCloseTo(1, within(ROUNDING));
    }

    @Test
    void aSoundMeshIsLeftAloneAndSaidSo() {
        MeshRepair.Result result = MeshRepair.repair(Shapes.box(1, 2, 3), 1e-3);
        assertThat(result.mesh().triangles())
                .containsExactly(Shapes.box(1, 2, 3).triangles());
        assertThat(result.report()).hasToString("Nothing to repair.");
    }

    @Test
    void aNegativeToleranceIsRefused() {
        assertThatThrownBy(() -> MeshRepair.weld(Shapes.box(1, 1, 1), -1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("-1.0 mm");
    }
}
