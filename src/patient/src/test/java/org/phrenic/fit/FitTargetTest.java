package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/** A lung as a target, in a file. */
class FitTargetTest {
    private static final TriangleMesh LUNG = VirtualThorax.ofPreset("adult-male", Resolution.LOW)
            .find(StructureKind.LUNG, 0, Side.RIGHT)
            .orElseThrow()
            .mesh();

    @TempDir
    Path folder;

    private TriangleMesh read(TriangleMesh mesh) {
        Path file = folder.resolve("lung_R.ply");
        MeshFiles.write(file, mesh);
        return FitTarget.read(file.toString()).surface();
    }

    @Test
    void aWholeSurfaceIsTakenAsItIs() {
        TriangleMesh read = read(LUNG);
        TriangleMesh stored = MeshFiles.read(folder.resolve("lung_R.ply"));
        assertThat(read.positions()).containsExactly(stored.positions());
        assertThat(read.triangles()).containsExactly(stored.triangles());
    }

    /** Files have triangles with vertices of their own, and some that are collapsed to an edge. */
    @Test
    void aSurfaceInPiecesIsJoinedAndTrianglesWithoutAnAreaAreLeftOut() {
        TriangleMesh soup = Shapes.soup(LUNG);
        int[] triangles = Arrays.copyOf(soup.triangles(), soup.triangles().length + 3);
        triangles[triangles.length - 2] = 1;
        TriangleMesh read = read(new TriangleMesh(soup.positions(), triangles));
        assertThat(read.vertexCount()).isEqualTo(LUNG.vertexCount());
        assertThat(read.triangleCount()).isEqualTo(LUNG.triangleCount());
        assertThat(count(LungBaseVertices.of(read))).isEqualTo(count(LungBaseVertices.of(LUNG)));
    }

    @Test
    void aSurfaceOfNoAreaIsRefused() {
        assertThatThrownBy(() -> read(new TriangleMesh(new double[] {0, 0, 0, 9, 0, 0}, new int[] {0, 1, 1})))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("lung_R.ply: found no triangle with an area, expected a surface");
    }

    @Test
    void aSurfaceWithACoordinateBeyondAnyBodyIsRefused() {
        double[] p = LUNG.positions().clone();
        p[4] = 1e30;
        assertThatThrownBy(() -> read(LUNG.withPositions(p)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("lung_R.ply: found a structure of 1.000e+30 mm, expected at most 3000 mm");
    }

    @Test
    void aLungBringsItsBaseAndBothInOneSayThatTheyBringNone() {
        List<FitTarget> one = FitTarget.withBases(List.of(FitTarget.of(FitPart.LUNG_RIGHT, LUNG)));
        assertThat(one).extracting(FitTarget::part).containsExactly(FitPart.LUNG_RIGHT, FitPart.LUNG_BASE_RIGHT);
        assertThat(FitTarget.withoutBase(one)).isEmpty();
        FitTarget both = FitTarget.of(FitPart.LUNGS, LUNG);
        assertThat(FitTarget.withBases(List.of(both))).containsExactly(both);
        assertThat(FitTarget.withoutBase(List.of(both)))
                .singleElement()
                .asString()
                .startsWith("The target lungs has no base of its own");
        assertThat(FitTarget.withoutBase(List.of(both, FitTarget.of(FitPart.LUNG_BASE_LEFT, LUNG))))
                .isEmpty();
        assertThat(FitTarget.withoutBase(List.of(both.withWeight(0)))).isEmpty();
    }

    private static int count(boolean[] mask) {
        int count = 0;
        for (boolean one : mask) {
            count += one ? 1 : 0;
        }
        return count;
    }
}
