package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.phrenic.cli.Phrenic;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.ReachedState;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;

class CopyCommandActionTest {
    private static final Scenario FIRST = WindowHarness.COARSE_SHEET;

    @Test
    void theCopiedLineGivesTheSameBitsWithoutAWindow() throws Exception {
        StringWriter help = new StringWriter();
        Phrenic.execute(new PrintWriter(help), new PrintWriter(help), "run", "--help");
        assertThat(help.toString()).as("options of phrenic run").contains("--steps", "--change");
        Session session = EventThread.get(() -> new Session(FIRST));
        try {
            EventThread.until(
                    "some steps are done", () -> session.live().status().timeS() > 0.2);
            EventThread.run(
                    () -> session.change("Stiffness", Assignment.read("test", "muscle_stiffness_n_per_m", "400")));
            EventThread.until(
                    "some more are done", () -> session.live().status().timeS() > 0.4);
            session.live().pause();
            EventThread.until("it stands still", () -> !session.live().status().playing());
            String hash = session.live().commandHash();
            String line = copied(session);
            assertThat(line).startsWith("phrenic run ").contains("muscle_stiffness_n_per_m=400");
            StringWriter out = new StringWriter();
            StringWriter err = new StringWriter();
            // Nothing in this line needs quotes.
            String[] words = (line + " --json").substring("phrenic ".length()).split(" ");
            int code = Phrenic.execute(new PrintWriter(out), new PrintWriter(err), words);
            assertThat(err.toString()).doesNotContain("phrenic:");
            assertThat(code).isZero();
            assertThat(out.toString()).contains(hash);
        } finally {
            EventThread.run(session::close);
        }
    }

    private static String copied(Session session) throws Exception {
        Clipboard clipboard = new Clipboard("test");
        AtomicReference<ReachedState> told = new AtomicReference<>();
        EventThread.run(() -> new CopyCommandAction(session, () -> clipboard).copy(told::set));
        EventThread.until("it is copied", () -> told.get() != null);
        return (String) clipboard.getData(DataFlavor.stringFlavor);
    }
}
