package org.phrenic.ui.window;

import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.Clipboard;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import java.util.stream.Stream;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.UserCache;
import org.phrenic.ui.widget.ClipboardText;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;

/** A dialog that lists the log records since the window opened. */
final class LogDialog extends Handler {
    private static final System.Logger LOG = System.getLogger(LogDialog.class.getName());
    private static final int MAX_LINES = 2_000;
    private static final String LOGGER_NAME = "org.phrenic";

    private final DefaultListModel<String> lines = new DefaultListModel<>();
    private final SimpleFormatter formatter = new SimpleFormatter();
    private final DateTimeFormatter clock =
            DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

    /** A strong reference: java.util.logging keeps loggers weakly. */
    private final Logger logger = Logger.getLogger(LOGGER_NAME);

    private JDialog dialog;

    LogDialog() {
        setLevel(Level.INFO);
        logger.addHandler(this);
    }

    /** Logs the notes of a loaded body and those about the user's cache. */
    static void logNotes(Thorax body) {
        Logger to = Logger.getLogger(LOGGER_NAME);
        Stream.concat(body.notes().stream(), UserCache.ofUser().takeNotes().stream())
                .forEach(note -> to.log(Level.INFO, note));
    }

    @Override
    public void publish(LogRecord record) {
        if (isLoggable(record)) {
            String line = clock.format(Instant.ofEpochMilli(record.getMillis())) + "  "
                    + record.getLevel().getName().toLowerCase(Locale.ROOT) + "  "
                    + formatter.formatMessage(record)
                    + (record.getThrown() == null ? "" : " (" + record.getThrown() + ")");
            SwingUtilities.invokeLater(() -> add(line));
        }
    }

    private void add(String line) {
        if (lines.size() == MAX_LINES) {
            lines.remove(0);
        }
        lines.addElement(line);
    }

    void showDialog(Window owner) {
        if (dialog == null) {
            dialog = createDialog(owner);
        }
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
    }

    private JDialog createDialog(Window owner) {
        JList<String> list = new JList<>(lines);
        list.getAccessibleContext().setAccessibleName("Log");
        JButton copy = Controls.button(
                "Copy", "Copy the selected lines, or all of them", () -> copy(list.getSelectedValuesList()));
        JPanel content = new JPanel(new MigLayout("insets 12", "[grow, fill]", "[grow, fill]"));
        content.add(new JScrollPane(list));
        JButton close = Dialogs.closing("Close", "Close the log", () -> {});
        return Dialogs.of(owner, "Log", content, new Dimension(760, 320), "", copy, close);
    }

    private void copy(List<String> chosen) {
        List<String> which = chosen.isEmpty() ? Collections.list(lines.elements()) : chosen;
        copy(String.join("\n", which), Toolkit.getDefaultToolkit().getSystemClipboard());
    }

    /** Copies a text; a clipboard that another program holds is told in the log. */
    static void copy(String text, Clipboard clipboard) {
        ClipboardText.copy(text, clipboard, refusal -> LOG.log(System.Logger.Level.WARNING, refusal));
    }

    @Override
    public void flush() {
        // Records are not buffered.
    }

    @Override
    public void close() {
        logger.removeHandler(this);
        if (dialog != null) {
            dialog.dispose();
        }
    }
}
