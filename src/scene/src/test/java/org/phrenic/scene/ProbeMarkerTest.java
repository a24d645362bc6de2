package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;

/** The probe in a scene. */
class ProbeMarkerTest {
    private static final ProbePose POSE = ProbePose.onSkin(
            new double[] {-90, -60, 20}, new double[] {-0.6, -0.8, 0}, new ProbePose.Angles(35, 20, -10), 6);

    private static TriangleMesh housing() {
        TriangleMesh parked = ProbeMarker.housing().rest();
        double[] at = parked.positions().clone();
        Frame.transform(ProbeMarker.housingPose(POSE), parked.positions(), at);
        return parked.withPositions(at);
    }

    /** Light and depth are those of its outside. */
    @Test
    void theHousingFacesOutwardWhereverItIsHeld() {
        assertThat(MeshMeasure.signedVolume(housing())).isPositive();
    }

    @Test
    void theHousingReachesFromTheFaceAwayFromTheBody() {
        double[] middle = housing().centre();
        assertThat(Vectors.dot(Vectors.subtract(middle, POSE.face()), POSE.axial()))
                .isNegative();
    }
}
