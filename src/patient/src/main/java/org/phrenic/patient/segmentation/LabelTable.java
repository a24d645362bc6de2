package org.phrenic.patient.segmentation;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.anatomy.StructureName;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * Maps each label of a volume to a structure. Several labels may map to the same structure, such as the lobes of a
 * lung.
 *
 * @param structures structure name by label: a structure of a thorax folder, {@link #LUNGS} or
 *     {@link #COSTAL_CARTILAGES}
 * @param missing labels or names in a user's table that the volume does not contain
 */
public record LabelTable(Map<Integer, String> structures, List<String> missing) {
    /** Both lungs under one label; split by {@link LungSplitter}. */
    public static final String LUNGS = "lungs";
    /** All ribs under one label; numbered from top to bottom. */
    public static final String RIBS = "ribs";
    /** All costal cartilages under one label; split by {@link CartilageSplitter}. */
    public static final String COSTAL_CARTILAGES = "costal_cartilages";
    /**
     * The built-in table: label numbers and names of the task {@code total} of TotalSegmentator (Wasserthal et al.
     * 2023, doi 10.1148/ryai.230024).
     */
    public static final String TOTALSEGMENTATOR = "totalsegmentator";

    private static final String SHIPPED = "/org/phrenic/data/labels/totalsegmentator.csv";

    public LabelTable {
        structures = Collections.unmodifiableMap(new TreeMap<>(structures));
        missing = List.copyOf(missing);
    }

    /** Creates a table without missing labels. */
    public LabelTable(Map<Integer, String> structures) {
        this(structures, List.of());
    }

    /**
     * Reads a table with the columns {@code label} or {@code name} (label number or name in the volume) and
     * {@code structure}. If both are present, names are used if the volume has any.
     *
     * @throws BadInputException if the table cannot be read or contains an unknown structure
     */
    public static LabelTable read(Path file, LabelVolume volume) {
        return of(file.toString(), CsvTable.read(file), volume, true);
    }

    /** The table for TotalSegmentator labels. */
    public static LabelTable totalSegmentator(LabelVolume volume) {
        return of("totalsegmentator.csv", shipped(), volume, false);
    }

    /**
     * Derives a table from the label names in the volume. Names of thorax folder structures and of TotalSegmentator are
     * known.
     *
     * @throws BadInputException if no name is known
     */
    public static LabelTable named(String file, LabelVolume volume) {
        CsvTable table = shipped();
        List<String> known = table.texts("name");
        Map<Integer, String> structures = new TreeMap<>();
        volume.names().forEach((label, name) -> {
            if (isStructure(name)) {
                structures.put(label, name);
            } else if (known.contains(name)) {
                structures.put(label, table.texts("structure").get(known.lastIndexOf(name)));
            }
        });
        if (structures.isEmpty()) {
            throw new BadInputException(file + ": found "
                    + (volume.names().isEmpty() ? "no names of labels" : "no name of a structure among its labels")
                    + ", expected --labels with a table, or --labels " + TOTALSEGMENTATOR);
        }
        return new LabelTable(structures);
    }

    private static CsvTable shipped() {
        try (InputStream in = LabelTable.class.getResourceAsStream(SHIPPED)) {
            if (in == null) {
                throw new IllegalStateException("the table of labels is missing from the program");
            }
            return CsvTable.parse("totalsegmentator.csv", new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static LabelTable of(String file, CsvTable table, LabelVolume volume, boolean tellAbsent) {
        List<String> structures = table.texts("structure");
        if (structures.isEmpty()) {
            throw new BadInputException(file + ": found no row, expected labels and their structures");
        }
        boolean byName = table.has("name") && !(volume.names().isEmpty() && table.has("label"));
        int[] counts = volume.grid().counts();
        Map<Integer, String> map = new TreeMap<>();
        List<String> absent = new ArrayList<>();
        for (int row = 0; row < structures.size(); row++) {
            String structure = structures.get(row);
            if (!isStructure(structure)) {
                throw table.badCell(
                        row,
                        "structure",
                        "found '" + structure + "', expected a structure such as rib_05_R, lung_L, liver, " + LUNGS
                                + " or " + COSTAL_CARTILAGES);
            }
            List<Integer> labels =
                    byName ? labelsNamed(volume, table.texts("name").get(row)) : List.of(label(table, row));
            labels.forEach(label -> map.put(label, structure));
            if (labels.stream().noneMatch(label -> label < counts.length && counts[label] > 0)) {
                absent.add((byName ? "name '" + table.texts("name").get(row) + "'" : "label " + labels.get(0)) + " ("
                        + structure + ")");
            }
        }
        if (map.isEmpty()) {
            throw new BadInputException(file + ": found no row for a label of the volume, expected some");
        }
        return new LabelTable(map, tellAbsent ? absent : List.of());
    }

    private static List<Integer> labelsNamed(LabelVolume volume, String name) {
        return volume.names().entrySet().stream()
                .filter(given -> given.getValue().equals(name))
                .map(Map.Entry::getKey)
                .toList();
    }

    private static int label(CsvTable table, int row) {
        double label = table.numbers("label")[row];
        if (label != (int) label || label < 1) {
            throw table.badCell(row, "label", "found " + label + ", expected a whole number from 1");
        }
        return (int) label;
    }

    private static boolean isStructure(String name) {
        return name.equals(LUNGS)
                || name.equals(RIBS)
                || name.equals(COSTAL_CARTILAGES)
                || StructureName.parse(name).isPresent();
    }
}
