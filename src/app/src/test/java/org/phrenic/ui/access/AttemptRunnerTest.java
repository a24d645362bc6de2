package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.session.QuitAfterWrites;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/** A window that is closed while the report of a finished attempt is composed, which keeps the attempt. */
class AttemptRunnerTest {
    private final List<Rehearsal> kept = new ArrayList<>();
    private final List<String> said = new ArrayList<>();
    private final List<String> refused = new ArrayList<>();
    private final List<String> ends = new ArrayList<>();
    private final QuitAfterWrites quit = new QuitAfterWrites(said::add, () -> true, () -> ends.add("end"));
    private Session session;
    private SceneViewport view;
    private RehearsalController rehearsal;

    @BeforeEach
    void open() {
        EventThread.run(() -> {
            AppearanceModel appearance = new AppearanceModel();
            session = new Session(Scenario.defaults().with("resolution=low"));
            session.addListener(new MessageListener(refused::add));
            view = new SceneViewport(session, appearance);
            rehearsal = new RehearsalController(session, appearance, view);
            rehearsal.addListener(new RehearsalController.Listener() {
                @Override
                public void onAttemptEnded(Rehearsal attempt) {
                    kept.add(attempt);
                }
            });
        });
    }

    @AfterEach
    void close() {
        EventThread.run(() -> {
            rehearsal.shutdown();
            view.close();
            session.close();
        });
    }

    @Test
    void theWindowClosesAfterTheAttemptIsKept() {
        CountDownLatch may = new CountDownLatch(1);
        EventThread.run(() -> {
            rehearsal.attempt.publish(() -> {
                may.await();
                return SampledAttempts.rehearsal();
            });
            quit.quit();
            assertThat(ends).isEmpty();
            assertThat(said).singleElement().asString().contains("the attempt");
        });
        may.countDown();
        EventThread.until("the end", () -> ends.size() == 1);
        EventThread.run(() -> assertThat(kept).hasSize(1));
    }

    @Test
    void anAttemptWithoutAReportIsNotWaitedForAfterItsReasonIsTold() {
        EventThread.run(() -> {
            rehearsal.attempt.publish(() -> {
                throw new IllegalStateException("no path over this breath");
            });
            quit.quit();
        });
        EventThread.until("the end", () -> ends.size() == 1);
        EventThread.run(() -> assertThat(refused).contains("no path over this breath"));
    }

    @Test
    void aRehearsalThatIsShutDownLeavesNothingToWaitFor() {
        CountDownLatch never = new CountDownLatch(1);
        EventThread.run(() -> {
            for (int attempt = 0; attempt < 2; attempt++) {
                rehearsal.attempt.publish(() -> {
                    never.await();
                    return SampledAttempts.rehearsal();
                });
            }
            rehearsal.shutdown();
            assertThat(FileWrites.underWay()).isEmpty();
        });
    }
}
