package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;

class RecordBinderTest {
    private static final String FULL =
            """
            name: body
            rate_per_min: 15
            count: 3
            side: left
            flag: true
            box_mm: [1, 2.5]
            inner: {top_y_mm: 7}
            rows:
              - [1, 2]
              - [3, 4]
            texts: [a, b]
            """;

    enum Hand {
        LEFT,
        RIGHT
    }

    record Inner(@Key("top_y_mm") double top) {
        Inner {
            if (top > 100) {
                throw new IllegalArgumentException("found a top of " + top + ", expected at most 100");
            }
        }
    }

    record Full(
            String name,
            @Key(above = 0, max = 150) double ratePerMin,
            @Key(min = 1, max = 4) int count,
            Hand side,
            boolean flag,
            @Key(count = 2) double[] boxMm,
            Inner inner,
            @Key(count = 2) List<double[]> rows,
            List<String> texts,
            Optional<Double> depth,
            @Key(absent = "0.5") double share,
            @Key(absent = "") List<String> more) {}

    private static Full bind(String text) {
        return YamlDocument.parse("f.yaml", text).bind(Full.class);
    }

    private static void refused(String text, String sentence) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> bind(text))
                .withMessage("f.yaml: " + sentence);
    }

    @Test
    void everyKindOfComponentIsBound() {
        Full full = bind(FULL);
        assertThat(full.name()).isEqualTo("body");
        assertThat(full.ratePerMin()).isEqualTo(15);
        assertThat(full.count()).isEqualTo(3);
        assertThat(full.side()).isEqualTo(Hand.LEFT);
        assertThat(full.flag()).isTrue();
        assertThat(full.boxMm()).containsExactly(1, 2.5);
        assertThat(full.inner()).isEqualTo(new Inner(7));
        assertThat(full.rows()).hasSize(2);
        assertThat(full.rows().get(1)).containsExactly(3, 4);
        assertThat(full.texts()).containsExactly("a", "b");
        assertThat(full.depth()).isEmpty();
        assertThat(full.share()).isEqualTo(0.5);
        assertThat(full.more()).isEmpty();
        assertThat(bind(FULL + "depth: 2\nshare: 1\n").depth()).contains(2.0);
    }

    @Test
    void problemsAreToldWithFileLineAndKey() {
        refused(FULL.replace("name:", "nam:"), "line 1, key 'nam': found an unknown key, did you mean 'name'?");
        refused(FULL.replace("flag: true\n", ""), "line 1, key 'flag': found no such key, expected true or false");
        refused(
                FULL.replace("min: 15", "min: 0"),
                "line 2, key 'rate_per_min': found '0', expected a number above 0 to 150");
        refused(FULL.replace("count: 3", "count: 9"), "line 3, key 'count': found '9', expected a number from 1 to 4");
        refused(FULL.replace("left", "up"), "line 4, key 'side': found 'up', expected left, right");
        refused(
                FULL.replace("[1, 2.5]", "[1]"),
                "line 6, key 'box_mm': found a list of 1, expected a list of 2 numbers");
        refused(FULL.replace("y_mm: 7", "y_mm: x"), "line 7, key 'inner.top_y_mm': found 'x', expected a number");
        refused(
                FULL.replace("y_mm: 7", "y_mm: 101"),
                "line 7, key 'inner': found a top of 101.0, expected at most 100");
        refused(FULL.replace("[3, 4]", "[3, b]"), "line 10, key 'rows[1][1]': found 'b', expected a number");
    }
}
