package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTable;
import javax.swing.JTextArea;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.ui.window.WindowHarness;

/** What the summary of an import shows of the diaphragm. */
class ImportSummaryDialogTest {
    private static final SheetQuality.Measure KEPT =
            new SheetQuality.Measure("smallest_angle_deg", "smallest angle", 15.61, "degrees", 10, false);
    private static final SheetQuality.Measure EXCEEDED =
            new SheetQuality.Measure("outside_cage_maximum_mm", "outside the cage", 12.345, "mm", 10, true);

    @BeforeAll
    static void display() {
        WindowHarness.assumeDisplay();
    }

    private static JDialog show(List<PatientStructure> structures, Optional<SheetQuality> quality, Runnable rehearse) {
        PatientBody body =
                new PatientBody("scanned", structures, List.of("sternum"), List.of("holes are filled, 7.6 ml"));
        return WindowHarness.onEdt(() -> {
            ImportSummaryDialog.show(
                    null,
                    new ImportResult(
                            "scan.mha", Optional.empty(), body, Optional.empty(), quality, Optional.empty(), List.of()),
                    rehearse);
            return WindowHarness.dialog("import.summary").orElseThrow();
        });
    }

    static PatientStructure structure(StructureKind kind, String name) {
        return structure(kind, name, new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}));
    }

    private static PatientStructure cube(String name, double millilitres) {
        double edge = 10 * Math.cbrt(millilitres);
        return structure(StructureKind.ORGAN, name, Shapes.box(edge, edge, edge));
    }

    private static PatientStructure structure(StructureKind kind, String name, TriangleMesh mesh) {
        return new PatientStructure(
                new Structure(name, kind, 0, Side.MIDLINE, mesh),
                PatientStructure.Source.VIRTUAL,
                Optional.empty(),
                Optional.empty());
    }

    private static Optional<JTable> quality(JDialog dialog) {
        return WindowHarness.find(dialog.getRootPane(), JTable.class, "Quality of the diaphragm");
    }

    @Test
    void everyMeasureIsARowAndSaysWhetherItsLimitIsExceeded() {
        AtomicBoolean rehearsed = new AtomicBoolean();
        JDialog dialog = show(
                List.of(structure(StructureKind.DIAPHRAGM, "diaphragm"), structure(StructureKind.RIB, "rib_07_R")),
                Optional.of(new SheetQuality(List.of(KEPT, EXCEEDED), Optional.empty())),
                () -> rehearsed.set(true));
        JTextArea notes = WindowHarness.find(dialog.getRootPane(), JTextArea.class, "Notes")
                .orElseThrow();
        assertThat(notes.getText()).isEqualTo("Holes are filled, 7.6 ml.");
        JTable structures = WindowHarness.find(dialog.getRootPane(), JTable.class, "Structures of the body")
                .orElseThrow();
        assertThat(structures.getValueAt(1, 0)).isEqualTo("Rib 7 right");
        JTable table = quality(dialog).orElseThrow();
        assertThat(row(table, 0)).containsExactly("Smallest angle", "15.61", "at least 10", "degrees", "");
        assertThat(row(table, 1)).containsExactly("Outside the cage", "12.35", "at most 10", "mm", "beyond");
        JButton button = WindowHarness.find(dialog.getRootPane(), JButton.class, "Rehearse")
                .orElseThrow();
        WindowHarness.doOnEdt(button::doClick);
        assertThat(rehearsed).isTrue();
        assertThat(dialog.isVisible()).isFalse();
    }

    @Test
    void aBodyWithoutADiaphragmHasNoTableOfIt() {
        JDialog dialog = show(List.of(), Optional.empty(), () -> {});
        assertThat(quality(dialog)).isEmpty();
        JButton button = WindowHarness.find(dialog.getRootPane(), JButton.class, "Rehearse")
                .orElseThrow();
        assertThat(button.isEnabled()).as("without a diaphragm no body opens").isFalse();
        WindowHarness.doOnEdt(dialog::dispose);
    }

    /** A number that is compared as text comes after 30 with 200, and before it with 4. */
    @Test
    void volumesAreSortedAsNumbers() {
        JDialog dialog = show(List.of(cube("liver", 200), cube("spleen", 30)), Optional.empty(), () -> {});
        JTable table = WindowHarness.find(dialog.getRootPane(), JTable.class, "Structures of the body")
                .orElseThrow();
        int volume = table.getColumn("Volume, ml").getModelIndex();
        WindowHarness.doOnEdt(() -> table.getRowSorter().toggleSortOrder(volume));
        assertThat(row(table, 0)).startsWith("Spleen", "virtual", "30");
        assertThat(row(table, 1)).startsWith("Liver", "virtual", "200");
        WindowHarness.doOnEdt(dialog::dispose);
    }

    private static List<String> row(JTable table, int row) {
        return WindowHarness.onEdt(() -> Stream.of(0, 1, 2, 3, 4)
                .map(column -> String.valueOf(table.getValueAt(row, column)))
                .toList());
    }
}
