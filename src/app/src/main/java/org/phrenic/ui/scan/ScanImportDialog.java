package org.phrenic.ui.scan;

import java.awt.Dimension;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.DefaultCellEditor;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.ExistingPath;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.scenario.RunSettings;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.Theme;

/**
 * Asks which label is which structure, how the volume lies in the body, what completes the body, and where its thorax
 * folder goes.
 */
final class ScanImportDialog {
    /** The answers of the dialog. */
    record Choice(ScanLabels labels, GeometryOverride geometry, Optional<String> template, Path folder) {}

    /** Receives the answers. */
    interface Start {
        void accept(Choice choice);
    }

    private static final Map<String, String> TEMPLATES = Map.of(
            "the virtual man", RunSettings.VIRTUAL_MAN,
            "the virtual woman", RunSettings.VIRTUAL_WOMAN,
            "nothing: keep what the scan has", "none");
    private static final String NUMBERS = "Label numbers as in";
    private static final String NO_STRUCTURE =
            "Choose a structure for at least one label: click in the column Structure.";
    private static final String NO_TOOL = "(none)";
    private static final Dimension SIZE = new Dimension(620, 560);
    /** The ending of a volume, with the number of a phase if there is one, behind a name. */
    private static final Pattern ENDING = Pattern.compile(
            "(?<=.)(\\.se[gq])?\\.(" + String.join("|", LabelVolumeFiles.READABLE) + ")(#\\d+)?$",
            Pattern.CASE_INSENSITIVE);

    private final Path file;
    private final ScanLabels labels;
    private final JLabel recognised = new JLabel();
    private final JLabel refused = new JLabel(" ");
    private final JComboBox<String> template =
            new JComboBox<>(TEMPLATES.keySet().stream().sorted().toArray(String[]::new));
    private final JTextField axes = new JTextField();
    private final JTextField spacing = new JTextField();
    private final JTextField folder = new JTextField();
    private final JButton start = Dialogs.closing("Import", "Import the scan with these labels", this::accept);
    private final JComboBox<String> numbers;
    private int numbersChosen;
    private Start onStart = choice -> {};

    ScanImportDialog(Path file, ScanLabels labels) {
        this.file = file;
        this.labels = labels;
        numbers = numbers();
        template.setSelectedItem("the virtual man");
        axes.setText(labels.axes());
        spacing.setText(labels.spacing());
        folder.setText(proposedFolder(file).toString());
        Controls.describe(
                axes,
                "Axes",
                "Sides of the body to which columns, rows and slices run: one each of L or R, P or A, S or I");
        Controls.describe(spacing, "Voxel, mm", "Size of a voxel along columns, rows and slices");
        Controls.describe(folder, "Thorax folder", "The folder that the body is written to");
        axes.setName("import.axes");
        labels.addTableModelListener(e -> showRecognised());
        List.of(axes, spacing, folder).forEach(field -> Controls.onEdit(field, this::enableStart));
        showRecognised();
    }

    /** The folder to write; empty if the text is none. */
    static Optional<Path> folder(String text) {
        try {
            return Optional.of(Path.of(text.strip())).filter(path -> !text.isBlank() && path.getNameCount() > 0);
        } catch (InvalidPathException noPath) {
            return Optional.empty();
        }
    }

    /** Whether a folder, or the nearest one above it that is there, can be written to. */
    static boolean isWritable(Path folder) {
        return ExistingPath.nearest(folder)
                .filter(nearest -> Files.isDirectory(nearest) && Files.isWritable(nearest))
                .isPresent();
    }

    /**
     * What of a folder an import writes over, in words: a body, also one of meshes alone, and a table of labels.
     *
     * @param withTable whether the import writes its table of labels
     */
    static List<String> replaced(Path folder, boolean withTable) {
        List<String> replaced = new ArrayList<>();
        if (ThoraxFolder.isBody(folder)) {
            replaced.add("the body");
        }
        if (withTable && Files.exists(folder.resolve(ScanImporter.LABELS_FILE))) {
            replaced.add(ScanImporter.LABELS_FILE);
        }
        return replaced;
    }

    /** A folder that does not exist, beside the scan, or in the home folder where nothing can be written beside it. */
    static Path proposedFolder(Path file) {
        Path place = file.toAbsolutePath();
        // The root of a disc has no name and lies in no folder.
        String name = place.getNameCount() > 0 ? place.getFileName().toString() : "scan";
        String stem = ENDING.matcher(name).replaceFirst("");
        Path beside = place.getNameCount() > 0 ? place.getParent() : place;
        Path parent = Files.isWritable(beside) ? beside : Path.of(System.getProperty("user.home"));
        return IntStream.iterate(1, n -> n + 1)
                .mapToObj(n -> parent.resolve(stem + "-body" + (n == 1 ? "" : "-" + n)))
                .filter(folder -> !Files.exists(folder))
                .findFirst()
                .orElseThrow();
    }

    private void accept() {
        onStart.accept(new Choice(
                labels,
                labels.geometry(axes.getText(), spacing.getText()),
                template(),
                folder(folder.getText()).orElseThrow()));
    }

    /** Shows the dialog, with the former answers if it was shown before; {@code whenStarted} receives the answers. */
    void show(Window owner, Start whenStarted) {
        onStart = whenStarted;
        start.setName("import.start");
        showRecognised();
        JButton cancel = Dialogs.closing("Cancel", "Import nothing", () -> {});
        JDialog dialog = Dialogs.of(owner, "Import scan", content(), SIZE, Disclaimer.TEXT, cancel, start);
        dialog.setName("import");
        dialog.setVisible(true);
    }

    /** Begins the import; its text names what the import replaces. */
    JButton start() {
        return start;
    }

    JPanel content() {
        JPanel content =
                new JPanel(new MigLayout("insets 14, gap 8, fill", "[][grow, fill][]", "[][][grow, fill][][][][][]"));
        List<String> heading = new ArrayList<>(List.of(file.getFileName() + ", " + labels.size()));
        heading.addAll(labels.origin());
        JLabel of = new JLabel(String.join("; ", heading));
        of.setToolTipText(of.getText());
        content.add(of, "span 3, wmin 0, wrap");
        content.add(recognised, "span 2, wmin 0, split 2, growx");
        content.add(new JLabel(NUMBERS));
        content.add(numbers, "wrap");
        content.add(new JScrollPane(table()), "span 3, grow, wrap");
        content.add(new JLabel("Axes"));
        content.add(axes, "span 2, wmin 0, wrap");
        labels.axesProblem()
                .ifPresent(problem -> content.add(
                        new JLabel("<html>" + Controls.capitalise(problem) + "."), "skip 1, span 2, wmin 0, wrap"));
        content.add(new JLabel("Voxel, mm"));
        content.add(spacing, "span 2, wmin 0, wrap");
        content.add(new JLabel("Complete from"));
        content.add(
                Controls.describe(template, "Complete from", "Where structures come from that the scan lacks"),
                "span 2, wrap");
        content.add(new JLabel("Thorax folder"));
        content.add(folder, "wmin 0");
        content.add(
                Controls.button("Choose...", "Choose the folder that the body is written to", () -> FileDialogs.folder(
                                content, "Thorax folder", "", List.of())
                        .ifPresent(chosen -> folder.setText(chosen.toString()))),
                "wrap");
        refused.setForeground(Theme.WARNING_TEXT);
        content.add(refused, "span 3, wmin 0, growx");
        return content;
    }

    private JComboBox<String> numbers() {
        JComboBox<String> list = new JComboBox<>(labels.tools().toArray(String[]::new));
        list.insertItemAt(NO_TOOL, 0);
        list.setSelectedIndex(0);
        list.setPrototypeDisplayValue("totalsegmentator");
        list.addActionListener(e -> assign(list.getSelectedIndex(), list.getItemAt(list.getSelectedIndex())));
        return Controls.describe(
                list,
                NUMBERS,
                "Assign structures by the label numbers of a segmentation tool or a public data set; "
                        + NO_TOOL
                        + " keeps those that are proposed");
    }

    /** Assigns the structures of another choice; the one that is chosen again leaves those that were edited. */
    private void assign(int choice, String tool) {
        if (choice == numbersChosen) {
            return;
        }
        numbersChosen = choice;
        if (choice == 0) {
            labels.guessAgain();
        } else {
            labels.assignByNumber(tool);
        }
    }

    private JTable table() {
        JTable table = new JTable(labels);
        table.getAccessibleContext().setAccessibleName("Labels");
        table.setName("import.labels");
        table.putClientProperty("terminateEditOnFocusLost", true);
        JComboBox<String> structures = new JComboBox<>();
        structures.setEditable(true);
        structures.addItem(ScanLabels.NONE);
        labels.known().forEach(structures::addItem);
        table.getColumnModel().getColumn(ScanLabels.STRUCTURE_COLUMN).setCellEditor(new DefaultCellEditor(structures));
        return Dialogs.widths(Dialogs.leftByTab(table), 60, 200, 90, 200);
    }

    private Optional<String> template() {
        return Optional.of(TEMPLATES.get((String) template.getSelectedItem())).filter(t -> !t.equals("none"));
    }

    private void showRecognised() {
        recognised.setText(labels.unknown()
                .map(name -> "'" + name + "' is no structure, choose one of the list")
                .orElse(labels.recognised() + " of " + labels.getRowCount() + " labels become a structure"));
        enableStart();
    }

    private void enableStart() {
        boolean hasFolder =
                folder(folder.getText()).filter(ScanImportDialog::isWritable).isPresent();
        Optional<String> first = Stream.of(
                        check(
                                axes,
                                GeometryOverride.areAxes(axes.getText()),
                                "one each of L or R, P or A, S or I, such as LPS"),
                        check(
                                spacing,
                                GeometryOverride.isSpacing(spacing.getText()),
                                "three sizes in mm, each from 0.1 to 50, such as 1.75, 1.75, 1.25"),
                        check(folder, hasFolder, "a folder that can be written"),
                        labels.refusal().map(why -> Controls.capitalise(why) + "."),
                        Optional.of(NO_STRUCTURE).filter(sentence -> labels.recognised() == 0))
                .flatMap(Optional::stream)
                .findFirst();
        refused.setText(first.orElse(" "));
        refused.setToolTipText(first.orElse(null));
        String replaced = folder(folder.getText())
                .map(to -> String.join(" and ", replaced(to, labels.isEdited())))
                .orElse("");
        start.setText(replaced.isEmpty() ? "Import" : "Import and replace " + replaced);
        start.setEnabled(labels.unknown().isEmpty() && first.isEmpty());
    }

    /** Marks a field that is not valid; what is wrong with it, in one sentence. */
    private static Optional<String> check(JTextField field, boolean valid, String expected) {
        Optional<String> wrong = valid
                ? Optional.empty()
                : Optional.of(field.getAccessibleContext().getAccessibleName() + ": found '" + field.getText()
                        + "', expected " + expected + ".");
        Controls.mark(field, wrong);
        return wrong;
    }
}
