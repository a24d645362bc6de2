package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RenderTasksTest {
    /** Who waits for a picture waits no longer than the view draws. */
    @Test
    void whatIsNotRunIsToldSo() {
        List<String> told = new ArrayList<>();
        RenderTasks tasks = new RenderTasks();
        tasks.add(gl -> told.add("first"), () -> told.add("not first"));
        tasks.add(gl -> told.add("second"), () -> told.add("not second"));
        tasks.runNext(null);
        assertThat(tasks.isAnyWaiting()).isTrue();
        tasks.end();
        assertThat(tasks.isAnyWaiting()).isFalse();
        tasks.add(gl -> told.add("third"), () -> told.add("not third"));
        assertThat(told).containsExactly("first", "not second", "not third");
    }
}
