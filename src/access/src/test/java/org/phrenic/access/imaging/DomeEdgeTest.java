package org.phrenic.access.imaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/** The edge of the right dome on radiographs of a quiet breath, from the left, without bones and the other lung. */
class DomeEdgeTest {
    private static final int DOME_RIGHT = Observation.COLUMNS.indexOf("dome_right_mm");
    private static final double INTERVAL_S = 0.5;
    private static final double UNTIL_S = 2.1;
    /** Rows of the picture in a row of one with 512 rows for 400 mm. */
    private static final int FINE = 4;

    /** The place of {@code dome_right_mm} in the plan view of the sheet: half to the right, a third to the back. */
    private static double[] place(List<Surface> surfaces) {
        double[] box = surfaces.stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow()
                .rest()
                .bounds();
        double y = 0.5 * (box[1] + box[4]) + 0.33 * 0.5 * (box[4] - box[1]);
        return new double[] {0.75 * box[0] + 0.25 * box[3], y, 90};
    }

    /** The same list, with a grain of dust in place of each surface but skin, liver and right lung. */
    private static List<Surface> softTissue(List<Surface> surfaces) {
        TriangleMesh dust = Shapes.sphere(0.01, 1);
        return surfaces.stream()
                .map(s -> s.kind() == StructureKind.SKIN
                                || s.kind() == StructureKind.LIVER
                                || s.name().equals("lung_R")
                        ? s
                        : new Surface(
                                s.name(),
                                StructureKind.OTHER,
                                0,
                                Side.MIDLINE,
                                dust,
                                Surface.Motion.STILL,
                                new boolean[0]))
                .toList();
    }

    /** The row at whose upper border a column brightens most: lung above, liver below. */
    private static int edge(Radiograph picture, int column, int from, int to) {
        return IntStream.range(from, to)
                .boxed()
                .max((a, b) -> Double.compare(step(picture, column, a), step(picture, column, b)))
                .orElseThrow();
    }

    private static double step(Radiograph picture, int column, int row) {
        return picture.attenuation(column, row) - picture.attenuation(column, row - 1);
    }

    @Test
    void itFollowsTheHeightOfTheRightDomeWithinAPixel() {
        Scenario scenario = Scenario.defaults().with("mesh_vertices=3000", "preset=quiet");
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            SceneSurfaces scene = new SceneSurfaces(simulation);
            double[] place = place(scene.surfaces());
            CArm arm = new CArm(place, 90, 0, 1000, 700, new CArm.Detector(400.0 / FINE, 512, 512));
            Fluoroscope fluoroscope = new Fluoroscope(softTissue(scene.surfaces()), 2);
            Frame frame = scene.newFrame();
            int column = (int) Math.round(arm.project(place[0], place[1], place[2])[0]);
            int first = edge(fluoroscope.take(frame, arm, Fluoroscope.ENERGY_KEV), column, 64, 448);
            double restZ = place[2] + (255.5 - first) * arm.pixelMm() * 0.7;
            double lowest = 0;
            for (double due = INTERVAL_S; due < UNTIL_S; due += INTERVAL_S) {
                while (simulation.time() < due) {
                    simulation.step();
                }
                scene.capture(frame);
                double dome = frame.values()[DOME_RIGHT];
                lowest = Math.min(lowest, dome);
                double expected = arm.project(place[0], place[1], restZ + dome)[1];
                int found = edge(fluoroscope.take(frame, arm, Fluoroscope.ENERGY_KEV), column, 64, 448);
                assertThat((found - expected) / FINE).as("rows at %.1f s", due).isCloseTo(0, within(1.0));
            }
            assertThat(lowest).as("by more than 20 pixels").isLessThan(-20 * 0.7 * FINE * arm.pixelMm());
        }
    }
}
