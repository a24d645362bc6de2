package org.phrenic.ui.scan;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.DefaultTableModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.ui.widget.Controls;

/** Lists what an import built: the source and size of each structure, and the notes. */
final class ImportSummaryDialog {
    private static final String[] COLUMNS = {"Structure", "From", "Volume, ml", "Off the labels, mm", "Cut at"};
    private static final int VOLUME_COLUMN = 2;
    private static final Dimension SIZE = new Dimension(640, 560);
    private static final double MM3_PER_ML = 1000;

    private ImportSummaryDialog() {}

    /** Shows the summary beside the window; {@code rehearse} begins a rehearsal of liver access with the body. */
    static void show(Window owner, ImportResult result, Runnable rehearse) {
        JPanel content =
                new JPanel(new MigLayout("insets 14, gap 8, fill, wrap 1", "[grow, fill]", "[][grow][][140!]"));
        content.add(Controls.heading(result.body().name()));
        content.add(new JScrollPane(table(result.body())), "grow");
        content.add(new JLabel(missing(result.body())), "wmin 0");
        content.add(new JScrollPane(notes(result.body().notes())), "grow");
        JDialog dialog = new JDialog(owner, "Imported body");
        dialog.setName("import.summary");
        JPanel foot = new JPanel(new MigLayout("insets 0 14 14 14, fillx", "[grow]push[][]", ""));
        foot.add(Controls.secondaryLabel(Disclaimer.TEXT), "wmin 0");
        foot.add(Controls.button("Rehearse", "Rehearse liver access with this body", () -> {
            dialog.dispose();
            rehearse.run();
        }));
        JButton close = Controls.button("Close", "Close this summary", dialog::dispose);
        foot.add(close);
        dialog.getContentPane().add(content);
        dialog.getContentPane().add(foot, BorderLayout.SOUTH);
        dialog.getRootPane().setDefaultButton(close);
        dialog.setSize(SIZE);
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
    }

    private static String missing(PatientBody body) {
        return body.missing().isEmpty()
                ? "Nothing is missing from this body."
                : "Missing: " + String.join(", ", body.missing());
    }

    private static JTable table(PatientBody body) {
        DefaultTableModel model = new DefaultTableModel(COLUMNS, 0) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }

            @Override
            public Class<?> getColumnClass(int column) {
                return column == VOLUME_COLUMN ? Number.class : String.class;
            }
        };
        body.structures().forEach(s -> model.addRow(row(s)));
        JTable table = new JTable(model);
        table.getAccessibleContext().setAccessibleName("Structures of the body");
        table.setAutoCreateRowSorter(true);
        int[] widths = {200, 80, 90, 130, 70};
        for (int i = 0; i < widths.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(widths[i]);
        }
        return table;
    }

    private static Object[] row(PatientStructure s) {
        String off = s.scan()
                .map(scan -> String.format(
                        Locale.ROOT, "%.2f", scan.meshed().distanceToLabel().mean()))
                .orElse("");
        return new Object[] {
            s.structure().name(),
            s.source().name().toLowerCase(Locale.ROOT),
            Math.round(MeshMeasure.signedVolume(s.structure().mesh()) / MM3_PER_ML),
            off,
            s.scan().map(PatientStructure.Scan::cutAt).orElse("")
        };
    }

    private static JTextArea notes(List<String> notes) {
        JTextArea area = new JTextArea(notes.isEmpty() ? "No notes." : String.join(".\n", notes) + ".");
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setEditable(false);
        area.setCaretPosition(0);
        area.getAccessibleContext().setAccessibleName("Notes");
        return area;
    }
}
