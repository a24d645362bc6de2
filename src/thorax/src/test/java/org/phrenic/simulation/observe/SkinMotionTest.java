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
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

/** The belly of the coarse virtual man whose sheet is pushed down. */
class SkinMotionTest {
    private static final double DOWN_MM = 10;

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

    /** How far forward the foremost-moving point of the skin has come, mm. */
    private static List<Double> forward(Thorax body) {
        try (Simulation simulation = Simulation.of(Runs.scenario(Runs.sheetAlone()), body)) {
            Scene scene = simulation.scene();
            scene.pose().update(0);
            SkinningWeights bones =
                    SkinningWeights.of(scene.thorax(), scene.pose().cage());
            double[] now = scene.restPositions().clone();
            for (int k = 2; k < now.length; k += 3) {
                now[k] -= DOWN_MM;
            }
            List<Double> most = new ArrayList<>();
            for (Structure skin : scene.thorax().structuresOf(StructureKind.SKIN)) {
                double[] at = new SkinMotion(scene, skin, bones, scene.pose()).at(0, now);
                double[] rest = skin.mesh().positions();
                most.add(IntStream.range(0, rest.length / 3)
                        .mapToDouble(v -> rest[3 * v + 1] - at[3 * v + 1])
                        .max()
                        .orElseThrow());
            }
            return most;
        }
    }

    @Test
    void theBellyComesAsFarForwardIfTheSkinIsInTwoPieces() {
        List<Double> whole = forward(Runs.male());
        List<Double> halves = forward(withSkinInHalves(Runs.male()));
        assertThat(whole).hasSize(1);
        assertThat(whole.get(0)).isGreaterThan(3);
        assertThat(halves).hasSize(2).allSatisfy(most -> assertThat(most)
                .isCloseTo(whole.get(0), Percentage.withPercentage(3)));
        assertThat(halves.get(0)).isCloseTo(halves.get(1), within(0.2));
    }
}
