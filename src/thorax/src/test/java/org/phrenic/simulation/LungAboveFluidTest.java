package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.LungAboveFluid;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;

/** A right lung that ends far above the diaphragm, as with fluid between, follows it: fluid does not expand. */
class LungAboveFluidTest {
    /** End of inspiration of the deep breath. */
    private static final double INSPIRED_S = 3.6;

    private static double descent(Simulation simulation, IntStream nodes) {
        double[] rest = simulation.scene().restPositions();
        double[] now = new double[rest.length];
        simulation.system().layout().toCaller(simulation.system().positions(), now);
        return nodes.mapToDouble(n -> rest[3 * n + 2] - now[3 * n + 2])
                .average()
                .orElseThrow();
    }

    /** On a coarse mesh: base and dome go down together whatever the mesh. */
    @Test
    void itsBaseGoesDownWithTheDome() {
        Scenario scenario = Runs.scenario("mesh_vertices=5000", "preset=deep", "sternum=kinematic");
        Thorax thorax = LungAboveFluid.in(VirtualThorax.ofPreset("adult-male", OrganSettings.budget(scenario)));
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            while (simulation.time() < INSPIRED_S) {
                simulation.step();
            }
            Scene scene = simulation.scene();
            LungPart lungs = scene.lungs().orElseThrow();
            int right = IntStream.range(0, lungs.structures.size())
                    .filter(i -> lungs.structures.get(i).side() == Side.RIGHT)
                    .findFirst()
                    .orElseThrow();
            int first = lungs.firstNodes.get(right);
            int end = first + lungs.structures.get(right).mesh().vertexCount();
            IntPredicate ofRight = n -> n >= first && n < end;
            int[] base = Arrays.stream(scene.lungBase().orElseThrow().callerNodes())
                    .filter(ofRight)
                    .toArray();
            assertThat(base).hasSizeGreaterThan(50);
            DiaphragmPart part = scene.diaphragm();
            double dome = descent(
                    simulation,
                    IntStream.range(0, part.diaphragm.sheet().vertexCount())
                            .filter(v ->
                                    part.diaphragm.isTendon(v) && scene.restPositions()[3 * (part.firstNode + v)] < -30)
                            .map(v -> part.firstNode + v));
            assertThat(descent(simulation, Arrays.stream(base))).isBetween(0.85 * dome, 1.15 * dome);
        }
    }
}
