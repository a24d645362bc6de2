package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.simulation.Runs;

/** The belly of the coarse virtual man whose sheet is pushed down. */
class SkinMotionTest {
    private static final double DOWN_MM = 10;
    private static final Pushed MAN = new Pushed(Runs.male());

    private static Structure half(Structure skin, Side side) {
        TriangleMesh mesh = skin.mesh();
        int[] t = mesh.triangles();
        IntPredicate isOfSide = i -> side.sign() * (mesh.x(t[i]) + mesh.x(t[i + 1]) + mesh.x(t[i + 2])) >= 0;
        int[] kept = IntStream.range(0, t.length)
                .filter(i -> isOfSide.test(i / 3 * 3))
                .map(i -> t[i])
                .toArray();
        return new Structure(
                "skin_" + side.name().toLowerCase(java.util.Locale.ROOT),
                StructureKind.SKIN,
                0,
                Side.MIDLINE,
                new TriangleMesh(mesh.positions(), kept));
    }

    private static Thorax withSkinInHalves(Thorax body) {
        List<Structure> structures = new ArrayList<>();
        for (Structure s : body.structures()) {
            if (s.kind() == StructureKind.SKIN) {
                structures.add(half(s, Side.RIGHT));
                structures.add(half(s, Side.LEFT));
            } else {
                structures.add(s);
            }
        }
        return new Thorax(body.name(), structures, body.notes());
    }

    /** The skin of a body whose sheet has gone down, and what it sweeps. */
    private static final class Pushed {
        /** How far forward the foremost-moving point of each skin has come, mm. */
        final List<Double> forward = new ArrayList<>();
        /** Sum over the vertices of all skins of area times displacement along the normal, mm³. */
        double sweptBySkin;
        /** Volume below the abdominal face that the sheet has swept, mm³. */
        final double sweptBySheet;
        /** Height of the lower end of the sternum above that of the skin, mm. */
        final double wall;

        Pushed(Thorax body) {
            Scene scene = Runs.assembled(Runs.scenario(Runs.sheetAlone()), body);
            scene.pose().update(0);
            SkinningWeights bones =
                    SkinningWeights.of(scene.thorax(), scene.pose().cage());
            double[] now = scene.restPositions().clone();
            for (int k = 2; k < now.length; k += 3) {
                now[k] -= DOWN_MM;
            }
            double lowest = Double.POSITIVE_INFINITY;
            for (Structure skin : scene.thorax().structuresOf(StructureKind.SKIN)) {
                double[] at = new SkinMotion(scene, skin, bones, scene.pose()).at(0, now);
                double[] rest = skin.mesh().positions();
                double[] normals = MeshMeasure.vertexNormals(skin.mesh());
                double[] areas = MeshMeasure.vertexAreas(skin.mesh());
                double most = Double.NEGATIVE_INFINITY;
                for (int i = 0; i < rest.length; i++) {
                    sweptBySkin += areas[i / 3] * normals[i] * (at[i] - rest[i]);
                    most = i % 3 == 1 ? Math.max(most, rest[i] - at[i]) : most;
                }
                forward.add(most);
                lowest = Math.min(lowest, skin.mesh().bounds()[2]);
            }
            sweptBySheet = DOWN_MM * -areaSeenFromAbove(scene.diaphragm().abdominalTriangles(), now);
            wall = scene.thorax().structuresOf(StructureKind.STERNUM).stream()
                            .mapToDouble(s -> s.mesh().bounds()[2])
                            .min()
                            .orElseThrow()
                    - lowest;
        }
    }

    private static double areaSeenFromAbove(int[] t, double[] p) {
        double area = 0;
        for (int i = 0; i < t.length; i += 3) {
            int a = 3 * t[i];
            int b = 3 * t[i + 1];
            int c = 3 * t[i + 2];
            area += 0.5 * ((p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]));
        }
        return area;
    }

    @Test
    void theBellyComesAsFarForwardIfTheSkinIsInTwoPieces() {
        List<Double> whole = MAN.forward;
        List<Double> halves = new Pushed(withSkinInHalves(Runs.male())).forward;
        assertThat(whole).hasSize(1);
        assertThat(whole.get(0)).isGreaterThan(3);
        assertThat(halves).hasSize(2).allSatisfy(most -> assertThat(most)
                .isCloseTo(whole.get(0), Percentage.withPercentage(3)));
        assertThat(halves.get(0)).isCloseTo(halves.get(1), within(0.2));
    }

    /**
     * The weight of the wall, 320 mm from sternum to pubis, rises over its first fifth and falls over its last 0.35:
     * 0.725 in all, of which 0.1 lies within the rise. The virtual man's skin ends between the two.
     */
    @Test
    void theBellyTakesInWhatTheSheetSweepsTimesTheShareOfTheWallThatTheSkinHas() {
        double end = MAN.wall / 320;
        assertThat(end).isBetween(0.2, 0.65);
        double share = (0.1 + end - 0.2) / 0.725;
        assertThat(MAN.sweptBySheet).isPositive();
        assertThat(MAN.sweptBySkin).isCloseTo(share * MAN.sweptBySheet, Percentage.withPercentage(2));
    }
}
