package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/** A report that cannot be written. */
class AttemptReportWriterTest {
    private static final int SIDE = 64;

    @TempDir
    private Path folder;

    @Test
    void aPictureThatCannotBeWrittenIsToldInWordsAlone() throws IOException {
        Path file = Files.createFile(folder.resolve("a file"));
        List<Surface> surfaces = RehearsalPreparationTest.surfaces();
        Rehearsal attempt = SampledAttempts.rehearsal(surfaces, RehearsalPreparationTest.map(surfaces));
        Session session = EventThread.get(() -> new Session(Scenario.defaults().with("resolution=low")));
        SceneViewport view = EventThread.get(() -> new SceneViewport(session, new AppearanceModel()));
        try {
            List<String> problems = new ArrayList<>();
            EventThread.run(() -> new AttemptReportWriter(view, SIDE).save(attempt, "today", file, problems::add));
            EventThread.until("the reason", () -> !problems.isEmpty());
            assertThat(problems).singleElement().asString().contains("a file").doesNotContain("Exception");
        } finally {
            EventThread.run(view::close);
            session.close();
        }
    }
}
