package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

/** A window that is closed while files are written. */
class QuitAfterWritesTest {
    private final List<String> said = new ArrayList<>();
    private final List<String> ends = new ArrayList<>();
    private boolean mayLose = true;
    private int asked;
    private final QuitAfterWrites quit = new QuitAfterWrites(
            said::add,
            () -> {
                asked++;
                return mayLose;
            },
            () -> ends.add("end"));

    private void quit() {
        EventThread.run(quit::quit);
    }

    private static void writing(String what, CountDownLatch may, List<String> done) {
        EventThread.run(() -> FileWrites.execute(
                what,
                () -> {
                    may.await();
                    return "written";
                },
                done::add,
                done::add));
    }

    @Test
    void nothingIsWaitedForWhenNothingIsWritten() {
        quit();
        assertThat(ends).hasSize(1);
        assertThat(said).isEmpty();
    }

    @Test
    void whoIsAskedAboutALossMayStay() {
        mayLose = false;
        quit();
        assertThat(ends).isEmpty();
        mayLose = true;
        quit();
        assertThat(ends).hasSize(1);
        assertThat(asked).isEqualTo(2);
    }

    @Test
    void whoIsNotAskedLosesIt() {
        mayLose = false;
        EventThread.run(quit::close);
        assertThat(ends).hasSize(1);
        assertThat(asked).isZero();
    }

    @Test
    void whatIsBeingWrittenIsNamedAndWaitedFor() {
        CountDownLatch may = new CountDownLatch(1);
        CountDownLatch mayLater = new CountDownLatch(1);
        List<String> done = new ArrayList<>();
        writing("the report in /tmp/a", may, done);
        quit();
        assertThat(said).singleElement().asString().contains("/tmp/a");
        writing("/tmp/b.png", mayLater, done);
        may.countDown();
        EventThread.until("the report", () -> done.size() == 1);
        assertThat(ends).isEmpty();
        mayLater.countDown();
        EventThread.until("the end", () -> ends.size() == 1);
        quit();
        assertThat(ends).as("it ends once").hasSize(1);
    }

    @Test
    void aWriteThatFailsIsNotWaitedFor() {
        CountDownLatch may = new CountDownLatch(1);
        List<String> done = new ArrayList<>();
        EventThread.run(() -> FileWrites.execute(
                "/tmp/full.png",
                () -> {
                    may.await();
                    if (may.getCount() == 0) {
                        throw new IllegalStateException("no space");
                    }
                    return "";
                },
                done::add,
                done::add));
        quit();
        may.countDown();
        EventThread.until("the end", () -> ends.size() == 1);
        EventThread.until("the reason", () -> done.contains("no space"));
    }

    @Test
    void whoAsksAgainLeavesAtOnce() {
        CountDownLatch may = new CountDownLatch(1);
        List<String> done = new ArrayList<>();
        writing("the report in /tmp/a", may, done);
        quit();
        quit();
        assertThat(ends).hasSize(1);
        assertThat(asked).isEqualTo(1);
        may.countDown();
        EventThread.until("the report", () -> done.size() == 1);
        EventThread.run(() -> assertThat(ends).hasSize(1));
    }
}
