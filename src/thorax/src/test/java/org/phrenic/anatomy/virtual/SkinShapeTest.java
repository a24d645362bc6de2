package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.mesh.TriangleMesh;

class SkinShapeTest {
    /** Between two rings, 7 mm apart, the surface is a chord of its profile. */
    private static final double CHORD_MM = 0.7;

    /** Breadth, front and back where the surface passes a height, by its triangles' edges. */
    private static double[] section(TriangleMesh skin, double z) {
        double[] found = {0, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        int[] corners = skin.triangles();
        for (int c = 0; c < corners.length; c++) {
            int a = corners[c];
            int b = corners[c % 3 == 2 ? c - 2 : c + 1];
            double share = (z - skin.z(a)) / (skin.z(b) - skin.z(a));
            if (share >= 0 && share <= 1) {
                double x = skin.x(a) + share * (skin.x(b) - skin.x(a));
                double y = skin.y(a) + share * (skin.y(b) - skin.y(a));
                found[0] = Math.max(found[0], Math.abs(x));
                found[1] = Math.min(found[1], y);
                found[2] = Math.max(found[2], y);
            }
        }
        return found;
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void sectionsHaveTheirMeasuresAtTheirHeights(String preset) {
        VirtualThoraxParameters.Skin measures =
                VirtualThoraxParameters.preset(preset).skin();
        TriangleMesh skin = new SkinShape(measures).mesh();
        int last = measures.sections().size() - 1;
        for (ImmutableDoubleArray row : measures.sections().subList(1, last)) {
            double[] found = section(skin, row.at(0));
            for (int i = 0; i < found.length; i++) {
                assertThat(found[i])
                        .as("column %d at %s mm", i + 1, row.at(0))
                        .isCloseTo(row.at(i + 1), within(CHORD_MM));
            }
        }
    }
}
