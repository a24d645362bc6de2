package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Boxes of 40 x 40 x 40 mm and 20 x 20 x 20 mm that lie in one another by a known amount. */
class OrganContactTest {
    private static final TriangleMesh LARGE = box(0, 0, 0, 40);

    private static TriangleMesh box(double x, double y, double z, double edge) {
        double[] p = new double[24];
        for (int v = 0; v < 8; v++) {
            p[3 * v] = x + edge * (v & 1);
            p[3 * v + 1] = y + edge * (v >> 1 & 1);
            p[3 * v + 2] = z + edge * (v >> 2);
        }
        int[] t = {
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5
        };
        return new TriangleMesh(p, t);
    }

    private static List<OrganContact> contacts(StructureKind a, StructureKind b, TriangleMesh second) {
        return OrganContact.all(List.of(surface("a", a, LARGE), surface("b", b, second)), List.of(LARGE, second));
    }

    private static Surface surface(String name, StructureKind kind, TriangleMesh mesh) {
        return new Surface(name, kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    /** The small box is 6 mm in the large one, with a quarter of its breadth: 6/20 x 5/20 of it. */
    @Test
    void theOverlapIsThatOfTheSmallerAndTheDepthThatToTheNearestFace() {
        OrganContact contact = contacts(StructureKind.ORGAN, StructureKind.LUNG, box(34, 35, 10, 20))
                .get(0);
        assertThat(contact.overlapPercent()).isCloseTo(100 * 0.3 * 0.25, within(1.6));
        assertThat(contact.depthMm()).isCloseTo(5, within(1e-9));
        assertThat(contact.isWithin()).isFalse();
    }

    @Test
    void twoOrgansAreInOneAnotherByTheSameInEitherOrder() {
        Surface large = surface("large", StructureKind.ORGAN, LARGE);
        TriangleMesh mesh = box(34, 35, 10, 20);
        Surface small = surface("small", StructureKind.LUNG, mesh);
        OrganContact one =
                OrganContact.all(List.of(large, small), List.of(LARGE, mesh)).get(0);
        OrganContact other =
                OrganContact.all(List.of(small, large), List.of(mesh, LARGE)).get(0);
        assertThat(one.pair()).isEqualTo("large, small");
        assertThat(other).isEqualTo(new OrganContact("small", "large", one.overlapPercent(), one.depthMm()));
    }

    /** Two per cent and three millimetres are allowed, each whatever the other is. */
    @Test
    void eitherOfOverlapAndDepthCountsAlone() {
        assertThat(new OrganContact("a", "b", 2, 3).isWithin()).isTrue();
        assertThat(new OrganContact("a", "b", 3, 1).isWithin()).isFalse();
        assertThat(new OrganContact("a", "b", 1, 4).isWithin()).isFalse();
    }

    @Test
    void organsSideBySideHaveNeitherOverlapNorDepth() {
        OrganContact contact = contacts(StructureKind.ORGAN, StructureKind.LIVER, box(41, 0, 0, 20))
                .get(0);
        assertThat(contact.overlapPercent()).isZero();
        assertThat(contact.depthMm()).isZero();
        assertThat(contact.isWithin()).isTrue();
    }

    @Test
    void vesselsMayJoinOneAnotherAndRunThroughTheLiverButThroughNoOrgan() {
        TriangleMesh inside = box(10, 10, 10, 20);
        assertThat(contacts(StructureKind.VESSEL, StructureKind.VESSEL, inside)).isEmpty();
        assertThat(contacts(StructureKind.LIVER, StructureKind.VESSEL, inside)).isEmpty();
        OrganContact contact =
                contacts(StructureKind.ORGAN, StructureKind.VESSEL, inside).get(0);
        assertThat(contact.overlapPercent()).isCloseTo(100, within(1e-9));
        assertThat(contact.depthMm()).isCloseTo(10, within(1e-9));
    }

    @Test
    void bonesAreNotMeasured() {
        assertThat(contacts(StructureKind.RIB, StructureKind.LUNG, LARGE)).isEmpty();
    }
}
