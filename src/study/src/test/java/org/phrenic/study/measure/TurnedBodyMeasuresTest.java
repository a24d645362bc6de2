package org.phrenic.study.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/** What is measured of the surfaces of a body that lies turned by 30 degrees is what is measured of a straight one. */
class TurnedBodyMeasuresTest {
    private static final double TURN_DEG = 30;
    private static final double INSPIRED_S = 0.8;
    private static final Scenario SCENARIO = Runs.scenario(Runs.sheetAlone("mesh_vertices=3000"));
    private static final double SAME = 0.02;
    private static final List<String> WANTED = List.of(
            "rib_05_forward_mm",
            "rib_05_widening_mm",
            "rib_08_widening_mm",
            "rib_05_pump_deg",
            "rib_08_bucket_deg",
            "cartilage_05_forward_mm",
            "sternum_pitch_deg",
            "cage_breadth_mm",
            "cage_depth_mm",
            "dome_right_rib",
            "coronal_right_mm");

    private static Thorax turned(Thorax body) {
        double c = StrictMath.cos(StrictMath.toRadians(TURN_DEG));
        double s = StrictMath.sin(StrictMath.toRadians(TURN_DEG));
        RigidMotion turn = RigidMotion.of(new double[] {c, -s, 0, s, c, 0, 0, 0, 1}, new double[3]);
        return new Thorax(
                body.name(),
                body.structures().stream()
                        .map(structure -> {
                            double[] p = structure.mesh().positions().clone();
                            turn.apply(p);
                            return structure.withMesh(structure.mesh().withPositions(p));
                        })
                        .toList(),
                body.notes());
    }

    private static Map<String, Double> inspired(Thorax body) {
        try (Simulation simulation = Simulation.of(SCENARIO, body)) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            Frame frame = surfaces.newFrame();
            SceneObservables measures =
                    new SceneObservables(surfaces, simulation.scene().diaphragm().diaphragm, frame, WANTED);
            while (simulation.time() < INSPIRED_S) {
                simulation.step();
            }
            surfaces.capture(frame);
            double[] values = measures.measure(frame);
            Map<String, Double> found = new LinkedHashMap<>();
            for (String name : WANTED) {
                found.put(name, values[measures.columns().indexOf(name)]);
            }
            return found;
        }
    }

    @Test
    void measuresAreAlongTheAxesOfTheBody() {
        Thorax body = SimulationRun.loadThorax(SCENARIO);
        Map<String, Double> straight = inspired(body);
        Map<String, Double> turned = inspired(turned(body));
        straight.forEach((name, value) -> {
            assertThat(Math.abs(value)).as(name).isGreaterThan(0.1);
            assertThat(turned.get(name)).as(name).isCloseTo(value, within(SAME * Math.abs(value)));
        });
    }
}
