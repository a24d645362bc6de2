package org.phrenic.access.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;

/** Requests are executed in the order in which they are made, and a restart of the run is told by its time. */
class RequestOrderTest {
    @Test
    void turnsKeepTheirPlaceAmongOtherRequestsAndTheLastOfARowCounts() {
        List<String> done = new ArrayList<>();
        RequestQueue requests = new RequestQueue();
        requests.addTurn(() -> done.add("turn 1"));
        requests.addTurn(() -> done.add("turn 2"));
        requests.add(() -> done.add("aim"));
        requests.addTurn(() -> done.add("turn 3"));
        requests.add(() -> done.add("advance"));
        requests.addTurn(() -> done.add("turn 4"));
        List<String> refused = new ArrayList<>();
        requests.add(() -> {
            throw new BadInputException("sample");
        });
        requests.runAll(() -> done.add("after"), refused::add);
        assertThat(done)
                .filteredOn(what -> !what.equals("after"))
                .containsExactly("turn 2", "aim", "turn 3", "advance", "turn 4");
        assertThat(done).hasSize(10);
        assertThat(refused).containsExactly("sample");
        assertThat(requests.isEmpty()).isTrue();
    }

    @Test
    void aStepThatIsNotAfterTheLastOneIsTheFirstOfARestartedRun() {
        StepOrder order = new StepOrder();
        assertThat(order.step(0.05)).isFalse();
        assertThat(order.step(0.1)).isFalse();
        assertThat(order.step(0.05)).as("an earlier time").isTrue();
        assertThat(order.step(0.05)).as("the same time").isTrue();
        order.comesLater(0.05);
        assertThat(order.step(0.1)).isFalse();
        assertThat(order.frame(0.05)).as("the frame of a step before the last").isFalse();
        assertThat(order.isLast(0.1)).isTrue();
    }
}
