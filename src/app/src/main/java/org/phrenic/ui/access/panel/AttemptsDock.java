package org.phrenic.ui.access.panel;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.ui.access.AttemptReportWriter;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.ScrollablePanel;

/** The report card of an attempt, and all attempts of the session to compare. */
public final class AttemptsDock extends JPanel implements RehearsalListener {
    private static final String[] COLUMNS = {"", "Exercise", "Result", "mm off", "s", "no-go s"};
    private static final String[] TIPS = {
        "Number of the attempt",
        "What was rehearsed",
        "Hit or missed",
        "Distance between tip and middle of the target at the last sample, mm",
        "Time from the first contact with the skin, s",
        "Time in what is to be avoided, s"
    };
    private static final int[] WIDTHS = {22, 92, 58, 56, 44, 60};

    private final transient Session session;
    private final transient AttemptReportWriter saver;
    private final transient Supplier<Optional<Path>> chooser;
    private final transient List<Rehearsal> attempts = new ArrayList<>();
    private final Model model = new Model();
    private final JTable table = new JTable(model) {
        @Override
        protected javax.swing.table.JTableHeader createDefaultTableHeader() {
            return new javax.swing.table.JTableHeader(columnModel) {
                @Override
                public String getToolTipText(java.awt.event.MouseEvent e) {
                    int column = columnAtPoint(e.getPoint());
                    return column < 0 ? null : TIPS[column];
                }
            };
        }
    };
    private final ReportCard card = new ReportCard();
    private final WrappingLabel placeholder = WrappingLabel.secondary("No attempt yet");
    private final JButton retryButton = new JButton("Retry");
    private final JButton save = new JButton("Save report...");

    /** @param chooser asks for the folder of a report; null for the usual dialogue */
    public AttemptsDock(
            Session session, RehearsalController door, SceneViewport view, Supplier<Optional<Path>> chooser) {
        super(new BorderLayout());
        this.session = session;
        this.chooser = chooser == null ? () -> FileDialogs.folder(this, "Folder for the report") : chooser;
        saver = new AttemptReportWriter(view);
        setName("attempts");
        JPanel body = new ScrollablePanel(
                new MigLayout("insets 8 10 8 10, gap 6 8, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        placeholder.setTextIfChanged(
                "An attempt ends when the needle is out again after a sample. Its report card stands here then.");
        body.add(placeholder, "wmin 0");
        body.add(card, "wmin 0");
        retryButton.setToolTipText("The same target again, from the start (R)");
        retryButton.getAccessibleContext().setAccessibleName("Retry");
        retryButton.addActionListener(e -> door.retry());
        save.setToolTipText(
                "Write the report (HTML with pictures, and JSON) and the plan that repeats the attempt into a folder");
        save.getAccessibleContext().setAccessibleName("Save report");
        save.addActionListener(e -> selected().ifPresent(this::save));
        JPanel buttons = new JPanel(new MigLayout("insets 0, gap 6", "[grow, fill, sg][grow, fill, sg]"));
        buttons.add(retryButton);
        buttons.add(save);
        body.add(buttons, "wmin 0");
        JLabel heading = new JLabel("Attempts of this session");
        heading.putClientProperty("FlatLaf.styleClass", "h4");
        body.add(heading);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getAccessibleContext().setAccessibleName("Attempts of this session");
        table.setFillsViewportHeight(true);
        for (int i = 0; i < WIDTHS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(WIDTHS[i]);
        }
        table.getSelectionModel().addListSelectionListener(e -> selected().ifPresent(this::show));
        JScrollPane scroll = new JScrollPane(table);
        scroll.setPreferredSize(new Dimension(200, 160));
        body.add(scroll, "wmin 0");
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
        save.setEnabled(false);
        door.addListener(this);
    }

    private Optional<Rehearsal> selected() {
        int row = table.getSelectedRow();
        return row < 0 ? Optional.empty() : Optional.of(attempts.get(row));
    }

    private void show(Rehearsal rehearsal) {
        placeholder.setVisible(false);
        card.show(rehearsal);
        save.setEnabled(true);
        revalidate();
    }

    @Override
    public void onAttemptEnded(Rehearsal rehearsal) {
        attempts.add(rehearsal);
        model.fireTableRowsInserted(attempts.size() - 1, attempts.size() - 1);
        table.setRowSelectionInterval(attempts.size() - 1, attempts.size() - 1);
    }

    private void save(Rehearsal rehearsal) {
        chooser.get().ifPresent(folder -> {
            save.setEnabled(false);
            session.note("Writing the report into " + folder + ".");
            saver.save(rehearsal, folder, problem -> {
                save.setEnabled(true);
                if (problem.isEmpty()) {
                    session.note("Saved " + folder.resolve("report.html") + ".");
                } else {
                    session.refuse(problem);
                }
            });
        });
    }

    /** Attempts so far. */
    List<Rehearsal> attempts() {
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
            return COLUMNS.length;
        }

        @Override
        public String getColumnName(int column) {
            return COLUMNS[column];
        }

        @Override
        public Object getValueAt(int row, int column) {
            Rehearsal rehearsal = attempts.get(row);
            AttemptRecord record = rehearsal.record();
            return switch (column) {
                case 0 -> row + 1;
                case 1 -> rehearsal.plan().title();
                case 2 -> record.samples().isEmpty() ? "-" : record.hit() ? "hit" : "missed";
                case 3 ->
                    record.samples().isEmpty()
                            ? "-"
                            : oneDecimal(lastSample(record).distanceMm());
                case 4 -> oneDecimal(record.timeS());
                default -> oneDecimal(record.inNoGoS());
            };
        }

        private static TargetingError lastSample(AttemptRecord record) {
            return record.samples().get(record.samples().size() - 1);
        }

        private static String oneDecimal(double value) {
            return String.format(Locale.ROOT, "%.1f", value);
        }
    }
}
