package org.phrenic.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A key of a report ends with its unit, which a table shows beside its words. */
class QuantityKeyTest {
    @ParameterizedTest
    @CsvSource({
        "dome_right_mm, dome right, mm",
        "sheet_area_mm2, sheet area, mm^2",
        "lung_volume_change_ml, lung volume change, ml",
        "fibre_shortening_percent, fibre shortening, %",
        "neck_turn_deg, neck turn, deg",
        "wall_s, wall, s",
        "steps_per_s, steps per s, ''",
        "verdict, verdict, ''"
    })
    void theEndOfAKeyIsItsUnit(String key, String label, String unit) {
        assertThat(QuantityKey.parse(key)).isEqualTo(new QuantityKey(label, unit));
    }
}
