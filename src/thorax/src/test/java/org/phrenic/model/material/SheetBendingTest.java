package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.force.HingeBending;
import org.phrenic.engine.force.Hinges;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.file.UserCache;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class SheetBendingTest {
    private static final Thorax MALE = VirtualThorax.ofPreset("adult-male", new MeshBudget(2000));

    @Test
    void aStiffnessInNewtonMillimetresIsAThousandMillinewtonMillimetres() {
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.adult(6));
        MassSpringBuilder nodes = new MassSpringBuilder();
        double[] noCrura = new double[dome.sheet().vertexCount()];
        TissueLaw law = TissueLaw.membrane(300, 3);
        DiaphragmPart part = new DiaphragmPart(dome, new DiaphragmPart.Tissue(law, 10, 1, true, noCrura, 1, 1), nodes);
        Hinges hinges = SheetBending.hinges(part, nodes.positions(), 0.1);
        double[] milli = new double[hinges.count()];
        Arrays.fill(milli, 100);
        assertThat(hinges.rowSums())
                .isNotEmpty()
                .containsExactly(
                        Hinges.of(nodes.positions(), hinges.corners(), milli).rowSums());
    }

    /** Plates of the same thickness: D is in proportion to the membrane stiffness, from the start or by a slider. */
    @Test
    void softerMuscleBendsMoreEasilyInProportionFromTheStartAndWhileItRuns() {
        Scene usual = assembled(300);
        double[] expected = forces(bending(usual), displaced(usual));
        double most = Arrays.stream(expected).map(Math::abs).max().orElseThrow();
        assertThat(most).isGreaterThan(1);
        Scene soft = assembled(60);
        double[] found = forces(bending(soft), displaced(soft));
        Arrays.setAll(found, i -> 5 * found[i]);
        assertThat(found).containsExactly(expected, within(1e-12 * most));
        soft.tuning().settled();
        soft.tuning().applyTissue(scenario(300));
        assertThat(forces(bending(soft), displaced(soft))).containsExactly(expected, within(1e-9 * most));
        // Masses bear the stiffness: least masses are in proportion to it, but for those of nodes that crura hold.
        DiaphragmPart sheet = usual.diaphragm();
        Set<Integer> held = Arrays.stream(sheet.cruralNodes).boxed().collect(Collectors.toSet());
        for (int i = 0; i < sheet.diaphragm.sheet().vertexCount(); i++) {
            int node = sheet.firstNode + i;
            if (!held.contains(node)) {
                double least = usual.nodeMasses().of(node, 0, 0, 1);
                assertThat(soft.nodeMasses().of(node, 0, 0, 1)).isCloseTo(least / 5, withPercentage(1e-6));
            }
        }
    }

    /** A scene is at rest where it has settled, which is not quite the shape that it was given. */
    @Test
    void forcesAtRestStayWhenTheMuscleBecomesStiffer() {
        Scenario scenario = scenario(300).with("bending_stiffness_n_mm=2");
        try (Simulation simulation = Simulation.of(scenario, MALE, UserCache.off())) {
            Scene scene = simulation.scene();
            double[] rest = scene.layout().toInternal(scene.restPositions());
            double[] before = forces(bending(scene), rest);
            double most = Arrays.stream(before).map(Math::abs).max().orElseThrow();
            assertThat(most).as("of bending from the given shape").isGreaterThan(1);
            scene.tuning().applyTissue(scenario.with("muscle_stiffness_n_per_m=3000"));
            assertThat(forces(bending(scene), rest)).containsExactly(before, within(1e-9 * most));
        }
    }

    private static Scenario scenario(double newtonPerMetre) {
        return Runs.scenario("mesh_vertices=2000", "lungs=off", "sternum=kinematic", "threads=1")
                .with("muscle_stiffness_n_per_m=" + newtonPerMetre);
    }

    private static Scene assembled(double newtonPerMetre) {
        return Runs.assembled(scenario(newtonPerMetre), MALE);
    }

    private static HingeBending bending(Scene scene) {
        return scene.system().fields().stream()
                .filter(HingeBending.class::isInstance)
                .map(HingeBending.class::cast)
                .findFirst()
                .orElseThrow();
    }

    /** Positions off those of the scene by up to 0.5 mm, internal order, the same each time. */
    private static double[] displaced(Scene scene) {
        double[] x = scene.layout().toInternal(scene.restPositions());
        Random random = new Random(3);
        Arrays.setAll(x, i -> x[i] + random.nextDouble() - 0.5);
        return x;
    }

    private static double[] forces(HingeBending field, double[] x) {
        double[] force = new double[x.length];
        for (int block = 0; block < NodeLayout.natural(x.length / 3).blockCount(); block++) {
            field.addForces(x, new double[x.length], force, block);
        }
        return force;
    }
}
