package org.phrenic.ui.scan;

import java.awt.Dimension;
import java.awt.Window;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.DefaultTableModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.AbsentObstacles;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;

/** Lists what an import built: source and size of each structure, quality of the diaphragm, and the notes. */
final class ImportSummaryDialog {
    private static final String[] COLUMNS = {"Structure", "From", "Volume, ml", "Off the labels, mm", "Cut at"};
    private static final int VOLUME_COLUMN = 2;
    private static final Dimension SIZE = new Dimension(660, 590);

    private ImportSummaryDialog() {}

    /** Shows the summary beside the window; {@code rehearse} begins a rehearsal of liver access with the body. */
    static void show(Window owner, ImportResult result, Runnable rehearse) {
        JTabbedPane tables = new JTabbedPane();
        tables.addTab("Structures", new JScrollPane(table(result.body())));
        result.quality().ifPresent(quality -> tables.addTab(title(quality), new JScrollPane(table(quality))));
        JPanel content =
                new JPanel(new MigLayout("insets 14, gap 8, fill, wrap 1", "[grow, fill]", "[][grow][][110:140:]"));
        content.add(Controls.heading(result.body().name()));
        content.add(tables, "grow");
        content.add(Dialogs.wrappedText(missing(result.body())), "wmin 0");
        content.add(new JScrollPane(notes(result.body().notes())), "grow");
        JButton rehearseButton = Dialogs.closing("Rehearse", "Rehearse liver access with this body", rehearse);
        // The window goes on with the former body.
        rehearseButton.setEnabled(result.body().canBreathe());
        JDialog dialog = Dialogs.of(
                owner,
                "Imported body",
                content,
                SIZE,
                Disclaimer.TEXT,
                rehearseButton,
                Dialogs.closing("Close", "Close this summary", () -> {}));
        dialog.setName("import.summary");
        dialog.setVisible(true);
    }

    private static String title(SheetQuality quality) {
        long good =
                quality.measures().stream().filter(SheetQuality.Measure::isGood).count();
        return "Diaphragm: " + good + " of " + quality.measures().size() + " within limits";
    }

    private static JTable table(SheetQuality quality) {
        String[][] rows = quality.measures().stream()
                .map(m -> new String[] {
                    Controls.capitalise(m.what()),
                    Numbers.format("%.2f", m.value()),
                    Numbers.format("%s %.0f", m.atMost() ? "at most" : "at least", m.limit()),
                    m.unit(),
                    m.isGood() ? "" : "beyond"
                })
                .toArray(String[][]::new);
        JTable table = Dialogs.table("Quality of the diaphragm", rows, "Measure", "Value", "Limit", "Unit", "");
        return Dialogs.widths(table, 300, 60, 90, 70, 60);
    }

    private static String missing(PatientBody body) {
        String ofCage = body.missing().isEmpty()
                ? "No structure of the cage is missing"
                : "Missing: " + String.join(", ", body.missing());
        List<String> names =
                body.structures().stream().map(s -> s.structure().name()).toList();
        return ofCage
                + AbsentObstacles.sentence(names).map(absent -> "; " + absent).orElse("") + ".";
    }

    private static JTable table(PatientBody body) {
        DefaultTableModel model = new DefaultTableModel(COLUMNS, 0) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }

            @Override
            public Class<?> getColumnClass(int column) {
                return column == VOLUME_COLUMN ? Long.class : String.class;
            }
        };
        body.structures().forEach(s -> model.addRow(row(s)));
        JTable table = new JTable(model);
        table.getAccessibleContext().setAccessibleName("Structures of the body");
        table.setAutoCreateRowSorter(true);
        return Dialogs.widths(Dialogs.leftByTab(table), 200, 80, 90, 130, 70);
    }

    private static Object[] row(PatientStructure s) {
        String off = s.scan()
                .map(scan ->
                        Numbers.format("%.2f", scan.meshed().distanceToLabel().mean()))
                .orElse("");
        return new Object[] {
            StructureLabels.of(s.structure().name()),
            s.source().name().toLowerCase(Locale.ROOT),
            Math.round(MeshMeasure.signedVolumeMl(s.structure().mesh())),
            off,
            s.scan().map(PatientStructure.Scan::cutAt).orElse("")
        };
    }

    private static JTextArea notes(List<String> notes) {
        String sentences =
                notes.stream().map(note -> Controls.capitalise(note) + ".").collect(Collectors.joining("\n"));
        JTextArea area = new JTextArea(notes.isEmpty() ? "No notes." : sentences);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setEditable(false);
        area.setCaretPosition(0);
        area.getAccessibleContext().setAccessibleName("Notes");
        return area;
    }
}
