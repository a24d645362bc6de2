package org.phrenic.study.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;

/** The table of physiology: what comes with the program, and what is refused. */
class PhysiologyTableTest {
    private static final String GOOD =
            """
            rows:
              - key: a_quantity
                preset: quiet
                observable: dome_right_mm
                reduction: fall
                low: 12
                high: 24
                unit: mm
                confidence: R+
                source: someone
            """;

    @TempDir
    Path folder;

    private PhysiologyTable read(String text) throws IOException {
        Path file = folder.resolve("table.yaml");
        Files.writeString(file, text);
        return PhysiologyTable.read(file);
    }

    @Test
    void aRowIsReadAsItStands() throws IOException {
        ReferenceRange row = read(GOOD).ranges().get(0);
        assertThat(row.key()).isEqualTo("a_quantity");
        assertThat(row.reduction()).isEqualTo(Reduction.FALL);
        assertThat(row.confidence()).isEqualTo(Confidence.CONFIDENT);
        assertThat(row.contains(12)).isTrue();
        assertThat(row.contains(24.1)).isFalse();
        assertThat(row.contains(Double.NaN)).isFalse();
    }

    @Test
    void theShippedTableHasASourceForEveryRowAndAllThatTheModelCanAnswer() {
        PhysiologyTable table = PhysiologyTable.shipped();
        assertThat(table.ranges()).hasSizeGreaterThan(100).allMatch(row -> !row.source()
                .isBlank());
        assertThat(table.ranges().stream().map(ReferenceRange::key))
                .contains(
                        "dome_right_full_litre",
                        "order_back_to_front_right_deep",
                        "right_dome_rib_full_expiration",
                        "tendon_vertebra_deep",
                        "apposition_share_rest",
                        "rib_03_pump",
                        "hold_creep");
    }

    @Test
    void ofTwoRangesThatExcludeOneAnotherEachSaysSo() {
        Map<String, ReferenceRange> rows = PhysiologyTable.shipped().ranges().stream()
                .collect(Collectors.toMap(ReferenceRange::key, Function.identity()));
        ReferenceRange ultrasound = rows.get("dome_left_deep_male");
        ReferenceRange slices = rows.get("dome_left_deep_gierada");
        assertThat(ultrasound.low()).isGreaterThan(slices.high());
        assertThat(ultrasound.missReason()).contains("dome_left_deep_gierada", "one of the two is always missed");
        assertThat(slices.missReason()).contains("dome_left_deep_male", "misses one of the two");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "source: someone; sauce: someone; line 10; did you mean 'source'",
                "preset: quiet; preset: quite; line 3; found 'quite', expected quiet",
                "observable: dome_right_mm; observable: dome_rigth_mm; line 4; did you mean 'dome_right_mm'?",
                "reduction: fall; reduction: drop; line 5; found 'drop', expected start",
                "low: 12; low: twelve; line 6; found 'twelve', expected a number",
                "low: 12; low: 30; line 6; found 30.0 above high 24.0",
                "confidence: R+; confidence: sure; line 9; found 'sure', expected S",
                "key: a_quantity; key: A quantity; line 2; small letters",
                "unit: mm; note: x; rows; found no such key",
                "reduction: fall; reduction: ratio; rows; key 'rows[0].against'",
                "reduction: fall; reduction: order; rows; observables",
                "preset: quiet; preset: none; rows; why the quantity cannot be measured",
                "unit: mm; share: 1.5; rows; more than 0 to 1",
                "unit: mm; share: 0.6; rows; found it with reduction fall",
                "unit: mm; body: child; rows; found 'child', expected male, female",
                "rows; lines; line 1; unknown key",
            })
    void whatIsWrongIsToldInOneSentenceWithItsPlace(String good, String bad, String place, String problem) {
        String text = bad.startsWith("share") || bad.startsWith("body")
                ? GOOD + "    " + bad + "\n"
                : GOOD.replaceFirst(java.util.regex.Pattern.quote(good), bad);
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("table.yaml")
                .hasMessageContaining(place)
                .hasMessageContaining(problem)
                .message()
                .satisfies(m -> assertThat(m.lines()).hasSize(1));
    }

    @Test
    void whatARowThatIsNotMeasuredDoesNotReadIsRefused() {
        String unmeasured = GOOD.replace("preset: quiet", "preset: none") + "    note: not modelled\n";
        assertThatThrownBy(() -> read(unmeasured))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found it with preset none, expected none there");
    }

    @Test
    void thePresetOfTheSecondObservableIsRefusedWhereItIsNotRead() throws IOException {
        String second = "    against: lung_volume_change_ml\n    against_preset: deep\n";
        for (String read : new String[] {"ratio", "at_share"}) {
            ReferenceRange row = read(GOOD.replace("reduction: fall", "reduction: " + read) + second)
                    .ranges()
                    .get(0);
            assertThat(row.againstPreset()).contains("deep");
        }
        for (String unread : new String[] {"slope", "hysteresis"}) {
            assertThatThrownBy(() -> read(GOOD.replace("reduction: fall", "reduction: " + unread) + second))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("against_preset")
                    .hasMessageContaining("found it with reduction " + unread + ", expected none but with ratio");
        }
    }

    @Test
    void aReasonForAMissIsNotEmptyAndNotOfWhatIsNotMeasured() {
        assertThatThrownBy(() -> read(GOOD + "    missed_because: ''\n"))
                .hasMessageContaining("found nothing, expected why the range is missed");
        String none = GOOD.replace("preset: quiet", "preset: none") + "    note: x\n    missed_because: y\n";
        assertThatThrownBy(() -> read(none)).hasMessageContaining("what is not measured is not missed");
    }

    @Test
    void aKeyStandsOnceAndAtLeastOneBoundIsNeeded() {
        String row = GOOD.substring(GOOD.indexOf("  - key"));
        assertThatThrownBy(() -> read(GOOD + row)).hasMessageContaining("'a_quantity' a second time");
        assertThatThrownBy(() -> read(GOOD.replace("    low: 12\n", "").replace("    high: 24\n", "")))
                .hasMessageContaining("found neither low nor high");
        assertThatThrownBy(() -> read("rows: []\n")).hasMessageContaining("found no row");
    }
}
