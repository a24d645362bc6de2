package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/** Bodies are made once, unless making them fails. */
class BodyPoolTest {
    /** Memory that is used up is no property of a run: its row would be failed for ever. */
    @Test
    void memoryThatIsUsedUpEndsTheStudyAndTheBodyIsMadeLater() {
        BodyPool pool = new BodyPool();
        AtomicInteger made = new AtomicInteger();
        Thorax thorax = SimulationRun.loadThorax(Scenario.defaults().with("resolution=low"));
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
}
