package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

class BoneCarriageTest {
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    private static final TriangleMesh LUNG = MAN.find("lung_R").orElseThrow().mesh();
    private static final BoneCarriage FULL = new BoneCarriage(MAN, 1);

    /**
     * Greatest difference of the displacements of two neighbouring vertices farther than 30 mm from bone, per mm of
     * their distance.
     */
    private static double greatestStrain(double[] u) {
        double[] p = LUNG.positions();
        double[] far = SkinningWeights.of(MAN, FULL.cage()).distances(p);
        int[] edges = new MeshTopology(LUNG).edges();
        double greatest = 0;
        for (int e = 0; e < edges.length; e += 2) {
            double du = 0;
            double dp = 0;
            for (int axis = 0; axis < 3; axis++) {
                int a = 3 * edges[e] + axis;
                int b = 3 * edges[e + 1] + axis;
                du += (u[a] - u[b]) * (u[a] - u[b]);
                dp += (p[a] - p[b]) * (p[a] - p[b]);
            }
            if (far[edges[e]] > 30 && far[edges[e + 1]] > 30) {
                greatest = Math.max(greatest, Math.sqrt(du / dp));
            }
        }
        return greatest;
    }

    @Test
    void theMediastinalSideOfALungDoesNotFoldWhereItsNearestBoneChanges() {
        double[] ofBone = FULL.carried(LUNG.positions());
        for (int i = 0; i < ofBone.length; i++) {
            ofBone[i] -= LUNG.positions()[i];
        }
        assertThat(greatestStrain(ofBone)).isGreaterThan(1);
        assertThat(greatestStrain(FULL.displacement(LUNG))).isLessThan(0.8);
    }

    /** Ribs turn back to where they stand at expiration: down, and the lung beside them with them. */
    @Test
    void theSideOfALungByTheRibsGoesWithThemWhenTheyTurnBack() {
        double[] p = LUNG.positions();
        double[] u = FULL.displacement(LUNG);
        double[] ofBone = FULL.carried(p);
        double[] far = SkinningWeights.of(MAN, FULL.cage()).distances(p);
        double farthest = 0;
        double down = 0;
        for (int i = 0; i < p.length; i++) {
            if (far[i / 3] < 10) {
                assertThat(u[i]).isCloseTo(ofBone[i] - p[i], within(1e-9));
                double length = Math.sqrt(u[i - i % 3] * u[i - i % 3]
                        + u[i - i % 3 + 1] * u[i - i % 3 + 1]
                        + u[i - i % 3 + 2] * u[i - i % 3 + 2]);
                down = length > farthest ? -u[i - i % 3 + 2] : down;
                farthest = Math.max(farthest, length);
            }
        }
        assertThat(farthest).as("the way of the vertex that goes farthest, mm").isGreaterThan(3);
        assertThat(down).as("of which down, mm").isGreaterThan(0.5 * farthest);
    }
}
