package org.phrenic.ui.scan;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.table.AbstractTableModel;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.CsvWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.LabelGuess;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.label.LungMoments;
import org.phrenic.patient.label.NamesBeside;
import org.phrenic.patient.label.StatedAxes;
import org.phrenic.ui.session.NumberFormats;

/** The labels of a volume as a table: number, name and size, and the structure that each one becomes. */
final class ScanLabels extends AbstractTableModel {
    /** The entry of a label that is not imported. */
    static final String NONE = "not imported";

    static final int STRUCTURE_COLUMN = 3;
    /** Volumes below this are shown with a decimal, ml. */
    private static final double SMALL_ML = 10;

    private static final String[] COLUMNS = {"Label", "Name", "Volume, ml", "Structure"};

    private record Row(int label, String name, double millilitres) {}

    private final List<Row> rows = new ArrayList<>();
    private final List<String> structures = new ArrayList<>();
    /** Structures by row, as the file names them. */
    private final List<String> guessed;
    /** Structures by label, as the numbers of each tool or data set have them. */
    private final Map<String, Map<Integer, String>> numbered;

    private final String size;
    private final String axes;
    private final Optional<StatedAxes> contradicted;
    private final String spacing;
    private final Optional<String> refusal;
    private final List<String> origin;

    private ScanLabels(LabelVolume volume, LabelGuess guess, Thorax usual, LabelGrid stored, List<String> origin) {
        this.origin = origin;
        refusal = Optional.of(guess).filter(LabelGuess::isRefused).map(LabelGuess::reason);
        Map<Integer, String> table = guess.table().map(LabelTable::structures).orElse(Map.of());
        numbered = LabelTable.byTool(volume);
        int[] counts = volume.grid().counts();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0) {
                double millilitres = volume.grid().volumeMl(counts[label]);
                rows.add(new Row(label, volume.names().getOrDefault(label, ""), millilitres));
                structures.add(table.getOrDefault(label, NONE));
            }
        }
        guessed = List.copyOf(structures);
        size = stored.columns() + " x " + stored.rows() + " x " + stored.slices() + " voxels";
        axes = StatedAxes.letters(volume);
        contradicted = guess.table().flatMap(t -> StatedAxes.contradicted(volume, t, LungMoments.of(usual)));
        spacing = IntStream.range(0, 3)
                .mapToObj(direction -> NumberFormats.format(volume.grid().spacing(direction), 4))
                .collect(Collectors.joining(", "));
    }

    /**
     * Reads the labels of a volume and guesses their structures.
     *
     * @param usual a thorax whose lungs are of the usual shape
     * @throws BadInputException if the file is no label volume
     */
    static ScanLabels read(Path file, Thorax usual) {
        LabelVolume stored = LabelVolumeFiles.read(file);
        LabelVolume volume = NamesBeside.added(file, stored.withEmptyLayers());
        List<String> origin =
                volume.notes().subList(stored.notes().size(), volume.notes().size());
        return new ScanLabels(volume, LabelGuess.of(volume), usual, stored.grid(), origin);
    }

    /** Columns, rows and slices of the volume, as text. */
    String size() {
        return size;
    }

    /** Which files beside the volume name its labels or are left aside, each without a full stop. */
    List<String> origin() {
        return origin;
    }

    /** Sides of the body to which columns, rows and slices run: by the file, or as the structures lie. */
    String axes() {
        return contradicted.map(StatedAxes::seen).orElse(axes);
    }

    /** What the structures say against the axes of the file, one sentence without a full stop. */
    Optional<String> axesProblem() {
        return contradicted.map(StatedAxes::sentence);
    }

    /** Why the volume cannot be imported with any table, one sentence without a full stop. */
    Optional<String> refusal() {
        return refusal;
    }

    /** Size of a voxel along columns, rows and slices by the file, mm. */
    String spacing() {
        return spacing;
    }

    /** The geometry that differs from the file's, or that the structures contradict. */
    GeometryOverride geometry(String wantedAxes, String wantedSpacing) {
        boolean keepsAxes = contradicted.isEmpty() && wantedAxes.strip().equalsIgnoreCase(axes);
        return new GeometryOverride(
                keepsAxes ? Optional.empty() : Optional.of(wantedAxes.strip()),
                Optional.of(wantedSpacing).filter(text -> !text.equals(spacing)));
    }

    /** The number of labels that become a structure. */
    long recognised() {
        return structures.stream().filter(s -> !s.equals(NONE)).count();
    }

    /** The first name in the table that is no structure. */
    Optional<String> unknown() {
        return structures.stream()
                .filter(name -> !name.equals(NONE) && !LabelTable.isStructure(name))
                .findFirst();
    }

    /** Names of structures to choose from. */
    Set<String> known() {
        Set<String> known = new TreeSet<>();
        numbered.values().forEach(table -> known.addAll(table.values()));
        known.add(LabelTable.LUNGS);
        known.add(LabelTable.RIBS);
        known.add(LabelTable.RIGHT_RIBS);
        known.add(LabelTable.LEFT_RIBS);
        known.add(LabelTable.COSTAL_CARTILAGES);
        return known;
    }

    /** Names of tools and public data sets whose label numbers are known. */
    Set<String> tools() {
        return numbered.keySet();
    }

    /** Assigns structures by the label numbers of one of {@link #tools}; labels that it does not have are obstacles. */
    void assignByNumber(String tool) {
        for (int row = 0; row < rows.size(); row++) {
            Row label = rows.get(row);
            String other = OrganNames.other(label.name(), label.label());
            structures.set(row, numbered.get(tool).getOrDefault(label.label(), other));
        }
        fireTableDataChanged();
    }

    /** Assigns the structures that the file names. */
    void guessAgain() {
        Collections.copy(structures, guessed);
        fireTableDataChanged();
    }

    /** Whether the structures are others than guessed, so that the import writes the table. */
    boolean isEdited() {
        return !structures.equals(guessed);
    }

    /** Writes the table to a file if the guess was changed; empty if the import can guess it again. */
    Optional<Path> writeIfEdited(Path file) {
        if (!isEdited()) {
            return Optional.empty();
        }
        List<List<String>> lines = IntStream.range(0, rows.size())
                .mapToObj(row -> List.of(
                        String.valueOf(rows.get(row).label()),
                        structures.get(row).equals(NONE) ? LabelTable.IGNORE : structures.get(row)))
                .toList();
        CsvWriter.write(file, List.of("label", "structure"), lines);
        return Optional.of(file);
    }

    @Override
    public int getRowCount() {
        return rows.size();
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
    public Class<?> getColumnClass(int column) {
        return column == 0 || column == 2 ? Number.class : String.class;
    }

    @Override
    public Object getValueAt(int row, int column) {
        Row label = rows.get(row);
        return switch (column) {
            case 0 -> label.label();
            case 1 -> label.name();
            case 2 -> millilitres(label.millilitres());
            default -> structures.get(row);
        };
    }

    /** A volume as a whole number, with one decimal where it is small. */
    private static Number millilitres(double volume) {
        boolean small = volume < SMALL_ML;
        return small ? Math.round(10 * volume) / 10.0 : Math.round(volume);
    }

    @Override
    public boolean isCellEditable(int row, int column) {
        return column == STRUCTURE_COLUMN;
    }

    @Override
    public void setValueAt(Object value, int row, int column) {
        structures.set(row, value.toString().strip());
        fireTableRowsUpdated(row, row);
    }
}
