package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.JButton;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.ui.access.AttemptReportWriter;
import org.phrenic.ui.access.IdleRehearsal;
import org.phrenic.ui.access.SampledAttempts;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.window.WindowHarness;

/** A session of more attempts than whole bodies fit into memory. */
class AttemptsDockTest {
    private static final TargetingError SHORT = new TargetingError(12, 5, false, 0, OptionalDouble.empty());

    private final List<String> messages = new ArrayList<>();
    private int folderQuestions;

    @Test
    void framesOfTheLastAttemptsAreKeptAndTableAndCardOfAll() {
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            session.addListener(new MessageListener(messages::add));
            AttemptsDock dock = new AttemptsDock(session, rehearsal, new AttemptReportWriter(view), () -> {
                folderQuestions++;
                return Optional.empty();
            });
            requireLastAttemptsWhole(dock);
        });
    }

    /** Pictures of two attempts in one folder would be mixed. */
    @Test
    void noSecondReportIsBegunWhileOneIsWritten(@TempDir Path folder) {
        List<JButton> saves = new ArrayList<>();
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            AttemptReportWriter writer = new AttemptReportWriter(view, 100, 1);
            AttemptsDock dock = new AttemptsDock(session, rehearsal, writer, () -> Optional.of(folder));
            dock.onAttemptEnded(SampledAttempts.rehearsal(SHORT));
            dock.onAttemptEnded(SampledAttempts.rehearsal());
            JTable table = WindowHarness.find(dock, JTable.class, "Attempts of this session")
                    .orElseThrow();
            JButton save =
                    WindowHarness.find(dock, JButton.class, "Save report").orElseThrow();
            save.doClick();
            table.setRowSelectionInterval(0, 0);
            assertThat(save.isEnabled()).isFalse();
            saves.add(save);
        });
        EventThread.until("the end of the first", saves.get(0)::isEnabled);
    }

    private void requireLastAttemptsWhole(AttemptsDock dock) {
        dock.onAttemptEnded(SampledAttempts.rehearsal(SHORT));
        String card = dock.card().text();
        for (int attempt = 0; attempt < AttemptsDock.KEPT_WHOLE; attempt++) {
            dock.onAttemptEnded(SampledAttempts.rehearsal());
        }
        assertThat(dock.attempts())
                .hasSize(AttemptsDock.KEPT_WHOLE + 1)
                .filteredOn(attempt -> attempt.whole().isEmpty())
                .containsExactly(dock.attempts().get(0));
        JTable table = WindowHarness.find(dock, JTable.class, "Attempts of this session")
                .orElseThrow();
        JButton save = WindowHarness.find(dock, JButton.class, "Save report").orElseThrow();
        table.setRowSelectionInterval(1, 1);
        save.doClick();
        assertThat(folderQuestions).isEqualTo(1);
        assertThat(messages).isEmpty();
        table.setRowSelectionInterval(0, 0);
        assertThat(dock.card().text()).isEqualTo(card).contains("13.0 mm");
        assertThat(table.getValueAt(0, 2)).isEqualTo("missed");
        save.doClick();
        assertThat(folderQuestions).isEqualTo(1);
        assertThat(messages).singleElement().asString().contains("last 12 attempts", "table and card are kept");
    }
}
