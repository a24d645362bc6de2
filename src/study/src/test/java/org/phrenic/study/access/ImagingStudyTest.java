package org.phrenic.study.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.scenario.Scenario;

class ImagingStudyTest {
    private static final Scenario SMALL =
            Scenario.defaults().with("resolution=low", "mesh_vertices=3000", "lungs=embedded", "sternum=kinematic");

    /**
     * The lightest sheet under the greatest pressure, undamped: no body bears it, and images of it are of no breath.
     */
    @Test
    void aBodyThatDivergesBesideTheImagesIsNoResult() {
        Scenario heavy = SMALL.with(
                "area_density_kg_per_m2=3",
                "greatest_pressure_kpa=20",
                "damping_rate_per_s=0",
                "muscle_stiffness_n_per_m=30",
                "time_step_s=0.01",
                "preset=deep",
                "rate_per_min=20");
        assertThatThrownBy(() -> ImagingStudy.of(heavy, 300, 0, 1))
                .isInstanceOf(DivergenceException.class)
                .hasMessageContaining("diverged");
    }

    @Test
    void theBreathOfTheScenarioIsNamed() {
        ImagingReport report = new ImagingReport(SMALL.with("preset=deep"), List.of(), List.of());
        assertThat(MarkdownPage.format(report.document(List.of()))).contains("the scene breathes (preset deep) on");
    }
}
