package org.phrenic.fit;

import java.util.List;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * A virtual patient of whom the second breath level is known: a body that comes with the program, made larger or
 * smaller along each axis and its ribs more or less oblique, and hidden settings of its breath.
 *
 * @param name what to call it
 * @param anatomy the body it is made of
 * @param width factor from side to side
 * @param depth factor from front to back; a barrel chest is deep
 * @param height factor from below upward
 * @param tilt by how much of its way to the back a point comes to lie higher: above 0 ribs are more oblique, below 0
 *     they lie flatter, as in age
 * @param hidden how it breathes: values of parameters, as {@code key=value}
 */
public record SyntheticPatient(
        String name, String anatomy, double width, double depth, double height, double tilt, List<String> hidden) {

    public SyntheticPatient {
        hidden = List.copyOf(hidden);
    }

    /** Five of both sexes, of several sizes and shapes. */
    public static List<SyntheticPatient> five() {
        String male = RunSettings.VIRTUAL_BODIES.get(0);
        String female = RunSettings.VIRTUAL_BODIES.get(1);
        return List.of(
                new SyntheticPatient(
                        "man of middle size",
                        male,
                        1,
                        1,
                        1,
                        0,
                        List.of("muscle_activation=0.5", "left_over_right=0.95", "rib_rotation=0.85")),
                new SyntheticPatient(
                        "tall man, ribs oblique",
                        male,
                        1.05,
                        1.02,
                        1.08,
                        0.06,
                        List.of(
                                "muscle_activation=0.66",
                                "left_over_right=1.2",
                                "greatest_pressure_kpa=2.5",
                                "rib_rotation=1.1")),
                new SyntheticPatient(
                        "old man, barrel chest, ribs flat",
                        male,
                        1.02,
                        1.12,
                        0.97,
                        -0.1,
                        List.of(
                                "muscle_activation=0.38",
                                "left_over_right=1.05",
                                "rib_rotation=0.6",
                                "lower_rib_rotation=0.8",
                                "muscle_stiffness_n_per_m=360")),
                new SyntheticPatient(
                        "woman of middle size",
                        female,
                        1,
                        1,
                        1,
                        0,
                        List.of(
                                "muscle_activation=0.55",
                                "left_over_right=1.15",
                                "pressure_left_over_right=0.8",
                                "greatest_pressure_kpa=3",
                                "upper_rib_rotation=1.2")),
                new SyntheticPatient(
                        "small woman, weak left side",
                        female,
                        0.94,
                        0.96,
                        0.93,
                        0.03,
                        List.of(
                                "muscle_activation=0.45",
                                "left_over_right=0.7",
                                "front_over_back=1.3",
                                "rib_rotation=0.9")));
    }

    /** The body at a resolution: meshes of two resolutions share no vertex. */
    public Thorax body(Resolution resolution) {
        Thorax grown = SimulationRun.loadThorax(Scenario.defaults()
                .with("anatomy=" + anatomy, "resolution=" + resolution.name().toLowerCase(java.util.Locale.ROOT)));
        return new Thorax(name, grown.structures().stream().map(this::shaped).toList(), grown.notes());
    }

    private Structure shaped(Structure structure) {
        double[] p = structure.mesh().positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] *= width;
            p[i + 2] = height * p[i + 2] + tilt * p[i + 1];
            p[i + 1] *= depth;
        }
        return structure.withMesh(structure.mesh().withPositions(p));
    }
}
