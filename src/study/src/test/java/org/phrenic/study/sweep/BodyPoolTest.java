package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Thorax;

/** Bodies are made once, unless making them fails. */
class BodyPoolTest {
    /** Memory that is used up is no property of a run: its row would be failed for ever. */
    @Test
    void memoryThatIsUsedUpEndsTheStudyAndTheBodyIsMadeLater() {
        BodyPool pool = new BodyPool();
        AtomicInteger made = new AtomicInteger();
        Thorax thorax = new Thorax("any", List.of(), List.of());
        assertThatThrownBy(() -> pool.get("body", () -> {
                    throw new OutOfMemoryError("Java heap space");
                }))
                .isInstanceOf(OutOfMemoryError.class);
        for (int run = 0; run < 3; run++) {
            assertThat(pool.get("body", () -> {
                        made.incrementAndGet();
                        return thorax;
                    }))
                    .isSameAs(thorax);
        }
        assertThat(made).hasValue(1);
    }

    /** A cohort of a thousand persons has as many bodies, all varied from one that is asked for again and again. */
    @Test
    void theEightLatestBodiesAreKept() {
        BodyPool pool = new BodyPool();
        List<String> made = new ArrayList<>();
        for (String key : "0 1 2 3 4 5 6 7 0 8 0 8 2 1".split(" ")) {
            pool.get(key, () -> {
                made.add(key);
                return new Thorax(key, List.of(), List.of());
            });
        }
        assertThat(made).containsExactly("0", "1", "2", "3", "4", "5", "6", "7", "8", "1");
    }
}
