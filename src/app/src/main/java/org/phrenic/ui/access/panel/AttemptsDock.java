package org.phrenic.ui.access.panel;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.JTableHeader;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.ui.access.AttemptHistory;
import org.phrenic.ui.access.AttemptReportWriter;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.ScrollablePanel;

/** The report card of an attempt, and a table of the attempts of the session. */
public final class AttemptsDock extends JPanel implements RehearsalController.Listener {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd HH.mm", Locale.ROOT);

    private record Column(String name, String tip, int width, Function<EndedAttempt, String> text) {}

    /**
     * Number of attempts, the last ones, of which the frames of the body are kept: of an attempt on a target of its own
     * some 100 MB at high resolution.
     */
    static final int KEPT_WHOLE = 12;

    private static final List<Column> COLUMNS = List.of(
            new Column("", "Number of the attempt", 22, null),
            new Column("Exercise", "What is rehearsed", 92, r -> r.plan().title()),
            column("Result", "Hit or missed", 58, r -> sample(r, s -> s.hit() ? "hit" : "missed")),
            column(
                    "mm off",
                    "Distance from the middle of the target at the nearest sample that hit, or else at the last, mm",
                    56,
                    r -> sample(r, s -> oneDecimal(s.distanceMm()))),
            column("s", "Time from the first contact with the skin, s", 44, r -> oneDecimal(r.timeS())),
            column("no-go s", "Time in no-go structures, s", 60, r -> oneDecimal(r.inNoGoS())));

    private final transient Session session;
    private final transient RehearsalController rehearsal;
    private final transient AttemptReportWriter writer;
    private final transient Supplier<Optional<Path>> chooser;
    private transient Optional<AttemptHistory> history = Optional.empty();
    private final transient List<EndedAttempt> attempts = new ArrayList<>();
    private final Model model = new Model();
    private final JTable table = new JTable(model) {
        @Override
        protected JTableHeader createDefaultTableHeader() {
            return new JTableHeader(columnModel) {
                @Override
                public String getToolTipText(MouseEvent e) {
                    int column = columnAtPoint(e.getPoint());
                    return column < 0 ? null : COLUMNS.get(column).tip;
                }
            };
        }
    };
    private final ReportCard card = new ReportCard();
    private final WrappingLabel placeholder = WrappingLabel.secondary("No attempt yet");
    private final JButton save = Controls.button(
            "Save report...",
            "Write the report (HTML with pictures, and JSON) and the plan that repeats the attempt into a folder",
            () -> selected().ifPresent(this::save));

    /** Whether a report is being written: another one, perhaps in the same folder, waits for its end. */
    private boolean writing;

    private final WrappingLabel curve = WrappingLabel.secondary("Learning curve");
    private final JButton export = Controls.button(
            "Export CSV...", "Write the attempts of all sessions, a row each, into a file", () -> FileDialogs.save(
                            this, "Attempts of all sessions", "attempts.csv")
                    .ifPresent(this::export));

    /** @param chooser asks for the folder of a report; null for a dialog */
    public AttemptsDock(
            Session session,
            RehearsalController rehearsal,
            AttemptReportWriter writer,
            Supplier<Optional<Path>> chooser) {
        super(new BorderLayout());
        this.session = session;
        this.rehearsal = rehearsal;
        this.chooser = chooser == null ? () -> newFolder() : chooser;
        this.writer = writer;
        setName("attempts");
        placeholder.setTextIfChanged(
                "An attempt ends when the needle is out again after a sample. Its report card is shown here.");
        save.setEnabled(false);
        JButton retry = Controls.button("Retry", "The same target again, from the start (R)", rehearsal::retry);
        JPanel buttons = Controls.panel("insets 0, gap 6", "[grow, fill, sg][grow, fill, sg]", retry, save);
        JPanel body = new ScrollablePanel(
                new MigLayout("insets 8 10 8 10, gap 6 8, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        body.add(placeholder, "wmin 0");
        body.add(card, "wmin 0");
        body.add(buttons, "wmin 0");
        body.add(Controls.heading("Attempts of this session"));
        body.add(tableScroll(), "wmin 0");
        body.add(curve, "wmin 0");
        body.add(export, "wmin 0");
        curve.setVisible(false);
        export.setVisible(false);
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
        rehearsal.addListener(this);
    }

    private JScrollPane tableScroll() {
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getAccessibleContext().setAccessibleName("Attempts of this session");
        table.setFillsViewportHeight(true);
        Dialogs.leftByTab(table);
        for (int i = 0; i < COLUMNS.size(); i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(COLUMNS.get(i).width);
        }
        table.getSelectionModel().addListSelectionListener(e -> selected().ifPresent(this::show));
        JScrollPane scroll = new JScrollPane(table);
        scroll.setPreferredSize(new Dimension(200, 160));
        return scroll;
    }

    private static Column column(String name, String tip, int width, Function<AttemptRecord, String> text) {
        return new Column(name, tip, width, r -> text.apply(r.record()));
    }

    private static String sample(AttemptRecord record, Function<TargetingError, String> text) {
        return record.decisive().map(text).orElse("-");
    }

    private static String oneDecimal(double value) {
        return Numbers.format("%.1f", value);
    }

    private Optional<EndedAttempt> selected() {
        int row = table.getSelectedRow();
        return row < 0 ? Optional.empty() : Optional.of(attempts.get(row));
    }

    private void show(EndedAttempt attempt) {
        placeholder.setVisible(false);
        card.show(attempt);
        save.setEnabled(!writing);
        revalidate();
    }

    /** Asks for a folder; one of its own is proposed, named by the time, such as "rehearsal 2026-11-25 16.21". */
    private Optional<Path> newFolder() {
        String proposed =
                "rehearsal " + LocalDateTime.now(ZoneId.systemDefault()).format(TIME);
        return FileDialogs.folder(this, "Folder for the report", proposed, AttemptReportWriter.FILES);
    }

    /** Keeps attempts over sessions. */
    public void keepIn(AttemptHistory kept) {
        history = Optional.of(kept);
        export.setVisible(true);
    }

    private void export(Path file) {
        try {
            history.orElseThrow().export(file);
            session.note("Saved " + file + ".");
        } catch (OutputException | BadInputException e) {
            session.refuse(e.getMessage());
        }
    }

    /** Adds an attempt by hand to the history, and tells the learning curve of its exercise. */
    private void keep(Rehearsal attempt) {
        if (history.isEmpty()) {
            return;
        }
        try {
            boolean byHand = attempt.plan().steps().stream()
                    .anyMatch(step -> step.place().startsWith("by hand"));
            if (byHand) {
                history.get().add(attempt);
            }
            curve.setTextIfChanged(history.get().learningCurve(attempt.plan().title()));
            curve.setVisible(!curve.getText().isEmpty());
        } catch (OutputException | BadInputException e) {
            boolean waits = history.get().waiting() > 0;
            session.refuse(e.getMessage()
                    + (waits ? "; the attempt is kept, and written with the next one or at the end" : ""));
        }
    }

    @Override
    public void onAttemptEnded(Rehearsal attempt) {
        keep(attempt);
        attempts.add(EndedAttempt.of(attempt, RehearsalReport.dateNow()));
        int last = attempts.size() - 1 - KEPT_WHOLE;
        if (last >= 0) {
            attempts.set(last, attempts.get(last).withoutFrames());
        }
        model.fireTableRowsInserted(attempts.size() - 1, attempts.size() - 1);
        table.setRowSelectionInterval(attempts.size() - 1, attempts.size() - 1);
    }

    private void save(EndedAttempt ended) {
        ended.whole()
                .ifPresentOrElse(
                        whole -> save(whole, ended.date()),
                        () -> session.refuse("A report is written of the last " + KEPT_WHOLE
                                + " attempts of the session; of this one table and card are kept."));
    }

    private void save(Rehearsal attempt, String date) {
        chooser.get().ifPresent(folder -> {
            setWriting(true);
            session.note("Writing the report into " + folder + ".");
            writer.save(
                    attempt,
                    date,
                    folder,
                    missing -> {
                        setWriting(false);
                        String saved = "Saved " + folder.resolve(AttemptReportWriter.PAGE);
                        session.note(saved + (missing.isEmpty() ? "." : " without all of its pictures: " + missing));
                    },
                    problem -> {
                        setWriting(false);
                        session.refuse(problem);
                    });
        });
    }

    private void setWriting(boolean on) {
        writing = on;
        save.setEnabled(!on);
        if (on) {
            // The focus of a button that is off would go to whatever comes next.
            rehearsal.needle().takeKeys();
        }
    }

    List<EndedAttempt> attempts() {
        return List.copyOf(attempts);
    }

    ReportCard card() {
        return card;
    }

    private final class Model extends AbstractTableModel {
        @Override
        public int getRowCount() {
            return attempts.size();
        }

        @Override
        public int getColumnCount() {
            return COLUMNS.size();
        }

        @Override
        public String getColumnName(int column) {
            return COLUMNS.get(column).name;
        }

        @Override
        public Object getValueAt(int row, int column) {
            return column == 0 ? row + 1 : COLUMNS.get(column).text.apply(attempts.get(row));
        }
    }
}
