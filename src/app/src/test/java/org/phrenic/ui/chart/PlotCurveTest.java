package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.simulation.observe.Observation;

/** Units of the plot's axes are those that the columns of the observables name. */
class PlotCurveTest {
    private static final Map<String, String> UNITS = Map.of("mm", "mm", "ml", "ml", "percent", "%");

    @Test
    void everyCurveHasTheUnitOfItsColumn() {
        assertThat(PlotCurve.ofObservables()).hasSizeGreaterThan(6).allSatisfy(curve -> {
            String ending = curve.column().substring(curve.column().lastIndexOf('_') + 1);
            assertThat(curve.unit()).as(curve.column()).isEqualTo(UNITS.getOrDefault(ending, "1"));
            assertThat(Observation.COLUMNS.get(curve.index())).isEqualTo(curve.column());
        });
        assertThat(PlotCurve.ofPoint(0).unit()).isEqualTo("mm");
    }
}
