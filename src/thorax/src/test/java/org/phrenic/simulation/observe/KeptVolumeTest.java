package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class KeptVolumeTest {
    /** An open piece of an organ is wound as its file winds it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void anOrganIsShrunkToItsVolumeAndNeverEnlargedHoweverItIsWound(boolean inward) {
        TriangleMesh rest = inward ? inside(Shapes.sphere(30, 2)) : Shapes.sphere(30, 2);
        double volume = MeshMeasure.signedVolume(rest);
        assertThat(volume < 0).isEqualTo(inward);
        KeptVolume kept = new KeptVolume(rest);
        double[] apart = scaled(rest, 1.1);
        kept.apply(apart);
        assertThat(MeshMeasure.signedVolume(rest.withPositions(apart))).isCloseTo(volume, within(1e-6 * 30 * 30 * 30));
        double[] together = scaled(rest, 0.9);
        kept.apply(together);
        assertThat(together).isEqualTo(scaled(rest, 0.9));
    }

    private static double[] scaled(TriangleMesh mesh, double factor) {
        return Arrays.stream(mesh.positions()).map(x -> factor * x).toArray();
    }

    private static TriangleMesh inside(TriangleMesh mesh) {
        int[] turned = mesh.triangles().clone();
        for (int t = 0; t < turned.length; t += 3) {
            turned[t] = mesh.triangles()[t + 1];
            turned[t + 1] = mesh.triangles()[t];
        }
        return new TriangleMesh(mesh.positions(), turned);
    }
}
