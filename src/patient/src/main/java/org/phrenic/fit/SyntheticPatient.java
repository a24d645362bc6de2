package org.phrenic.fit;

import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * A virtual patient with a known second breath level. A virtual body is scaled along each axis, and its ribs are made
 * more or less oblique. It breathes with hidden parameters.
 *
 * @param anatomy the virtual body
 * @param width scale factor from side to side
 * @param depth scale factor from front to back
 * @param height scale factor along z
 * @param tilt upward shift of a point per unit length toward the back; positive values make the ribs more oblique
 * @param hidden parameters of the breath, as {@code key=value}
 */
public record SyntheticPatient(
        String name, String anatomy, double width, double depth, double height, double tilt, List<String> hidden) {
    /** One line per patient: name, virtual man or woman, width, depth, height, tilt, hidden parameters. */
    private static final String FIVE =
            """
            man of middle size|man|1|1|1|0|muscle_activation=0.5 left_over_right=0.95 rib_rotation=0.85
            tall man, ribs oblique|man|1.05|1.02|1.08|0.06|muscle_activation=0.66 left_over_right=1.2 \
            greatest_pressure_kpa=2.5 rib_rotation=1.1
            old man, barrel chest, ribs flat|man|1.02|1.12|0.97|-0.1|muscle_activation=0.38 left_over_right=1.05 \
            rib_rotation=0.6 lower_rib_rotation=0.8 muscle_stiffness_n_per_m=360
            woman of middle size|woman|1|1|1|0|muscle_activation=0.55 left_over_right=1.15 \
            pressure_left_over_right=0.8 greatest_pressure_kpa=3 upper_rib_rotation=1.2
            small woman, weak left side|woman|0.94|0.96|0.93|0.03|muscle_activation=0.45 left_over_right=0.7 \
            front_over_back=1.3 rib_rotation=0.9
            """;

    public SyntheticPatient {
        hidden = List.copyOf(hidden);
    }

    /** Five patients of both sexes with different sizes and shapes. */
    public static List<SyntheticPatient> five() {
        return FIVE.lines()
                .map(row -> row.split("\\|"))
                .map(SyntheticPatient::of)
                .toList();
    }

    private static SyntheticPatient of(String[] row) {
        return new SyntheticPatient(
                row[0],
                row[1].equals("man") ? RunSettings.VIRTUAL_MAN : RunSettings.VIRTUAL_WOMAN,
                Double.parseDouble(row[2]),
                Double.parseDouble(row[3]),
                Double.parseDouble(row[4]),
                Double.parseDouble(row[5]),
                List.of(row[6].split(" ")));
    }

    /** The body at a resolution. Meshes of different resolutions share no vertices. */
    public Thorax body(Resolution resolution) {
        return body(settings(resolution));
    }

    /** The body that settings of a scenario name, shaped. */
    public Thorax body(List<String> settings) {
        Thorax plain = SimulationRun.loadThorax(Scenario.defaults().with(settings.toArray(String[]::new)));
        return new Thorax(name, plain.structures().stream().map(this::shaped).toList(), plain.notes());
    }

    /** Settings of a scenario that name the virtual body at a resolution. */
    List<String> settings(Resolution resolution) {
        return List.of("anatomy=" + anatomy, "resolution=" + resolution.name().toLowerCase(Locale.ROOT));
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
