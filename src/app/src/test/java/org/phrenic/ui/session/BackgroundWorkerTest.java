package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class BackgroundWorkerTest {
    /** The task that waits is told of, and the next one is done. */
    @Test
    void fullMemoryIsToldAndTheNextTaskIsDone() {
        List<String> told = new ArrayList<>();
        try (BackgroundWorker worker = new BackgroundWorker("test")) {
            EventThread.run(() -> {
                worker.run(
                        () -> {
                            throw new OutOfMemoryError("Java heap space");
                        },
                        done -> told.add("done"),
                        told::add);
                worker.run(() -> "next", told::add, told::add);
            });
            EventThread.until("the next task", () -> told.contains("next"));
        }
        assertThat(told).hasSize(2);
        assertThat(told.get(0)).startsWith("There is not enough memory");
    }
}
