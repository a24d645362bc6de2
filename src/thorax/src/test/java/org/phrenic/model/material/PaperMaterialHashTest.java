package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.Simulation;

/**
 * The material of Villard, Bourne and Bello 2009 on lungs that leave room for a heart of 459 ml (the man's) and 360 ml:
 * those of commit 690655c. Each scene ends in the state that commit ends in, bit for bit. At medium resolution the
 * woman's lungs of that commit pass through themselves, so they are smoothed now and no longer the same.
 */
@Execution(ExecutionMode.CONCURRENT)
class PaperMaterialHashTest {
    private static final List<String> MAN = List.of(
            "base_left_mm: [90, 4]",
            "heart_mm: [28, 66]",
            "heart_centre_mm: [-46, 120]",
            "heart_radii_mm: [45, 45]",
            "relaxation_sweeps: 12");
    private static final List<String> WOMAN = List.of(
            "base_left_mm: [83.7, 3.68]",
            "heart_mm: [26.04, 61.38]",
            "heart_centre_mm: [-42.32, 111.6]",
            "heart_radii_mm: [41.4, 41.85]",
            "relaxation_sweeps: 12");

    @ParameterizedTest
    @CsvSource({
        "adult-male, 120, resolution=low tendon=plane, '',"
                + " e6d574570837e45818e70e789d13bc0bac032b2a6adef049598a42e94fe5e968",
        "adult-female, 12, resolution=low, ''," + " c856fde6e87dd3f11d8d77b7a791f3082c41db85d18fea825f6fb81febcd5d9b",
        "adult-female, 12, resolution=high, ''," + " 6aa52d3b2be859271a8890d3d6c1f705033f501e69b2e693866cadd8abe8d879",
        "adult-male, 40, resolution=low integrator=rk2, '',"
                + " 38023a26214def6b6cf269d35ac1d3b7d6070eed9112408d78c4b8f3cb78f15b",
        "adult-male, 120, resolution=low, 20:muscle_force_mn=400 60:rib_rotation=1.3 80:integrator=rk4 100:preset=deep,"
                + " 33cbff3081ee65cb957ab549d4d1d7f971cba5ab0be8952bc8c4b6bc1250abea"
    })
    void onTheLungsOf690655cItEndsInTheSameState(String body, int steps, String settings, String changes, String hash) {
        List<String> assignments = new ArrayList<>(List.of("material=paper"));
        assignments.addAll(List.of(settings.split(" ")));
        Scenario scenario = Scenario.defaults().with(assignments.toArray(String[]::new));
        if (!changes.isEmpty()) {
            scenario = scenario.withChanges(Arrays.stream(changes.split(" "))
                    .map(ScheduledChange::parse)
                    .toList());
        }
        Thorax thorax = VirtualThorax.generate(measures(body), OrganSettings.budget(scenario));
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            while (simulation.steps() < steps) {
                simulation.step();
            }
            assertThat(simulation.stateHash()).isEqualTo(hash);
        }
    }

    private static VirtualThoraxParameters measures(String body) {
        String text = ShippedFile.text("thorax/" + body + ".yaml");
        for (String line : body.equals("adult-male") ? MAN : WOMAN) {
            String key = line.substring(0, line.indexOf(':'));
            String changed = text.replaceFirst("(?m)^  " + key + ": .*$", "  " + line);
            assertThat(changed).as(key).isNotEqualTo(text);
            text = changed;
        }
        return YamlDocument.parse(body, text).bind(VirtualThoraxParameters.class);
    }
}
