package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

class CruralOriginTest {
    private static final double REACH_MM = 15;
    private static final int LAST_THORACIC = StructureName.FIRST_LUMBAR - 1;
    private static final int THIRD_LUMBAR = StructureName.FIRST_LUMBAR + 2;

    private static Thorax body;
    private static Diaphragm diaphragm;
    private static double[] share;

    @BeforeAll
    static void find() {
        body = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        diaphragm =
                Diaphragm.withTrefoilTendon(body.find("diaphragm").orElseThrow().mesh());
        share = CruralOrigin.attachmentShares(body, diaphragm);
    }

    private static Thorax with(Predicate<Structure> kept) {
        return new Thorax("part", body.structures().stream().filter(kept).toList(), List.of());
    }

    private static boolean isOfTheOrigin(Structure s) {
        return (s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.DISC) && s.level() >= LAST_THORACIC;
    }

    @Test
    void bothCruraComeFromTheVertebraeAndNothingElseDoes() {
        TriangleMesh sheet = diaphragm.sheet();
        double top = body.structures().stream()
                .filter(CruralOriginTest::isOfTheOrigin)
                .mapToDouble(s -> s.mesh().bounds()[5])
                .max()
                .orElseThrow();
        int right = 0;
        int left = 0;
        for (int i = 0; i < share.length; i++) {
            assertThat(share[i]).isBetween(0.0, 1.0);
            if (share[i] > 0) {
                assertThat(sheet.z(i)).as("height of vertex %d", i).isLessThan(top + REACH_MM);
                assertThat(diaphragm.isTendon(i)).isFalse();
            }
            right += share[i] > 0.5 && sheet.x(i) < 0 ? 1 : 0;
            left += share[i] > 0.5 && sheet.x(i) > 0 ? 1 : 0;
        }
        assertThat(right).isGreaterThan(20);
        assertThat(left).isGreaterThan(20);
    }

    /** The median arcuate ligament crosses the aorta in front of T12. */
    @Test
    void itBeginsAtTheLastThoracicVertebra() {
        assertThat(CruralOrigin.attachmentShares(with(s -> s.level() >= LAST_THORACIC), diaphragm))
                .isEqualTo(share);
        double[] lumbarAlone = CruralOrigin.attachmentShares(with(s -> s.level() > LAST_THORACIC), diaphragm);
        assertThat(Arrays.stream(lumbarAlone).sum())
                .isLessThan(0.9 * Arrays.stream(share).sum());
    }

    /** T12 alone, 30 mm farther forward than it is, has the sheet in front of it, beside it and behind it. */
    @Test
    void whatLiesBehindTheLastThoracicVertebraIsNotAttachedToIt() {
        Structure vertebra = body.structures().stream()
                .filter(s -> s.kind() == StructureKind.VERTEBRA && s.level() == LAST_THORACIC)
                .findFirst()
                .orElseThrow();
        double[] p = vertebra.mesh().positions().clone();
        for (int i = 1; i < p.length; i += 3) {
            p[i] -= 30;
        }
        Structure forward = vertebra.withMesh(vertebra.mesh().withPositions(p));
        double[] found = CruralOrigin.attachmentShares(new Thorax("part", List.of(forward), List.of()), diaphragm);
        TriangleTree bone = new TriangleTree(forward.mesh());
        TriangleTree.Hit hit = new TriangleTree.Hit();
        TriangleMesh sheet = diaphragm.sheet();
        int behind = 0;
        int ahead = 0;
        for (int i = 0; i < found.length; i++) {
            if (bone.closest(sheet.x(i), sheet.y(i), sheet.z(i), REACH_MM, hit)) {
                double distance = Math.sqrt(hit.distanceSquared);
                double backward = (sheet.y(i) - hit.y) / distance;
                if (backward > 0.5) {
                    assertThat(found[i]).as("30 degrees behind, vertex %d", i).isZero();
                    behind++;
                } else if (backward <= 0) {
                    assertThat(found[i]).as("not behind, vertex %d", i).isEqualTo(FallOff.at(distance, REACH_MM));
                    ahead++;
                }
            }
        }
        assertThat(behind).isGreaterThan(5);
        assertThat(ahead).isGreaterThan(5);
    }

    @Test
    void itIsASmallPartOfTheSheet() {
        assertThat(Arrays.stream(share).sum() / share.length).isBetween(0.005, 0.1);
    }

    @Test
    void itEndsAtTheThirdLumbarVertebra() {
        // The disc of a level lies below its vertebra.
        Predicate<Structure> below = s -> isOfTheOrigin(s)
                && (s.level() > THIRD_LUMBAR || (s.level() == THIRD_LUMBAR && s.kind() == StructureKind.DISC));
        assertThat(CruralOrigin.attachmentShares(with(below.negate()), diaphragm))
                .isEqualTo(share);
        assertThat(CruralOrigin.attachmentShares(with(below), diaphragm)).containsOnly(0);
    }

    @Test
    void aBodyWithoutSpineThereHasNone() {
        double[] none = CruralOrigin.attachmentShares(with(s -> !isOfTheOrigin(s)), diaphragm);
        assertThat(none).hasSize(share.length).containsOnly(0);
    }

    @Test
    void itFadesWithoutAStep() {
        int[] edges = diaphragm.topology().edges();
        TriangleMesh sheet = diaphragm.sheet();
        // The profile's steepest slope is 1.54 over the reach (at 0.58 of it); the nearest bone is no farther from one
        // end than from the other plus the edge.
        double steepest = 1.55 / REACH_MM;
        // In front of T12 it fades round the bone too.
        double[] lumbar = CruralOrigin.attachmentShares(with(s -> s.level() > LAST_THORACIC), diaphragm);
        IntStream.range(0, edges.length / 2).forEach(e -> {
            int a = edges[2 * e];
            int b = edges[2 * e + 1];
            double length = Math.sqrt(Math.pow(sheet.x(a) - sheet.x(b), 2)
                    + Math.pow(sheet.y(a) - sheet.y(b), 2)
                    + Math.pow(sheet.z(a) - sheet.z(b), 2));
            assertThat(Math.abs(lumbar[a] - lumbar[b])).isLessThanOrEqualTo(steepest * length);
            assertThat(Math.abs(share[a] - share[b])).isLessThanOrEqualTo(3 * steepest * length);
        });
    }
}
