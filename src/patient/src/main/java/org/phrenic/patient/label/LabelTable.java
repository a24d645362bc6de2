package org.phrenic.patient.label;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

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
    /** All ribs of the right side under one label. */
    public static final String RIGHT_RIBS = "ribs_R";
    /** All ribs of the left side under one label. */
    public static final String LEFT_RIBS = "ribs_L";

    /** All costal cartilages under one label; split by {@link CartilageSplitter}. */
    public static final String COSTAL_CARTILAGES = "costal_cartilages";

    /** All bones under one label; ribs, sternum and spine are separated where they can be. */
    public static final String ALL_BONES = "bone_skeleton";
    /** All vertebrae under one label. */
    public static final String SPINE = "bone_spine";

    static final String SKIN = "skin";
    /** A label that is left out. */
    public static final String IGNORE = "ignore";
    /**
     * Begins the names of the aids of a plan of radiotherapy, such as rings and doses, which are no part of a body. A
     * name that {@link OrganNames#other} makes has no hyphen.
     */
    static final String OF_PLAN = OrganNames.OTHER_PREFIX + "planning-";
    /** Begins the note on these. */
    public static final String AIDS_LEFT_OUT = "margins and aids of a radiotherapy plan, left out: ";
    /** The name of TotalSegmentator's tables. */
    public static final String TOTALSEGMENTATOR = "totalsegmentator";

    /** Words of the names of what fills the space between organs, beside those of skin and muscles. */
    private static final Pattern BETWEEN_ORGANS =
            Pattern.compile("(.*_)?(fat|adipose|muscles?|tissues?|subcutaneous|cavity)(_.*)?");
    /** Words of names that have one of these beside them and are yet of something with a shape of its own. */
    private static final Pattern SHAPED = Pattern.compile(
            "(.*_)?(mass(es)?|tumou?rs?|lesions?|nodules?|cysts?|abscess|implants?|expanders?|effusions?"
                    + "|pleural|lungs?|brain|breasts?)(_.*)?");

    /** A few segments are kept free for parts that are told apart. */
    private static final int MAX_STRUCTURES = LabelGrid.MAX_BYTE_LABEL - 50;

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
     * {@code structure}, in any case and with or without leading zeros. If label and name are present, names are used
     * if the volume has any.
     *
     * @throws BadInputException if the table cannot be read, contains an unknown structure, or gives a label to two
     */
    public static LabelTable read(Path file, LabelVolume volume) {
        return of(file.toString(), CsvTable.read(file), volume);
    }

    /**
     * The table that {@code --labels} asks for: {@link #LUNGS} for a mask of both lungs, the name of a tool or a data
     * set ({@link #byTool}) in upper or lower case, or a file: a table ({@link #read}) or the names of labels
     * ({@link NameFile}). Names of the volume that are the tool's tell its labels; if there are none, that one of the
     * tool's versions does whose numbers fit the volume.
     *
     * @throws BadInputException as {@link #read}
     */
    public static LabelTable of(String asked, LabelVolume volume) {
        if (asked.equalsIgnoreCase(LUNGS)) {
            return new LabelTable(Map.of(1, LUNGS));
        }
        List<NumberTable> tables = NumberTable.named(asked);
        if (tables.isEmpty()) {
            if (!asked.contains(".") && !Files.exists(Path.of(asked))) {
                throw new BadInputException("--labels " + asked + ": found neither a file nor a table of this name,"
                        + " expected a CSV file, " + LUNGS + " or one of "
                        + String.join(", ", NumberTable.distinctNames()));
            }
            return ofFile(Path.of(asked), volume);
        }
        Map<Integer, String> named = new TreeMap<>();
        Map<Integer, String> names = new TreeMap<>(volume.names());
        names.putAll(NamedLabels.of(volume).names());
        tables.forEach(table -> names.forEach((label, name) -> {
            if (table.names().containsKey(name)) {
                named.putIfAbsent(label, table.names().get(name));
            }
        }));
        if (!named.isEmpty()) {
            return new LabelTable(named).withRest(volume);
        }
        NumberMatch match = NumberMatch.version(NumberMatch.positions(volume.grid()), tables);
        LabelTable table = new LabelTable(match.table().structures());
        return match.structures().isEmpty() ? table : table.withRest(volume);
    }

    private static LabelTable ofFile(Path file, LabelVolume volume) {
        Optional<Map<Integer, String>> names = NameFile.read(file);
        if (names.isEmpty() && NameFile.isJson(file)) {
            throw new BadInputException(file + ": found no names of labels, expected \"labels\" with a number for each"
                    + " name, or a name for each number");
        }
        return names.map(read -> ofNames(file, new LabelVolume(volume.grid(), read, volume.notes())))
                .orElseGet(() -> read(file, volume));
    }

    private static LabelTable ofNames(Path file, LabelVolume volume) {
        NamedLabels named = NamedLabels.of(volume);
        if (!named.areKnown()) {
            throw new BadInputException(file + ": found "
                    + (named.names().isEmpty()
                            ? "no name for a label of the volume"
                            : "no name of a structure for a label of the volume, as "
                                    + Numbers.quote(
                                            named.names().values().iterator().next()))
                    + ", expected some such as liver or lung_L");
        }
        return new LabelTable(named.structures()).withRest(volume);
    }

    /** Structures by label for each tool and public data set whose label numbers are known, by its name. */
    public static Map<String, Map<Integer, String>> byTool(LabelVolume volume) {
        LabelPositions positions = NumberMatch.positions(volume.grid());
        Map<String, Map<Integer, String>> structures = new LinkedHashMap<>();
        NumberTable.distinctNames()
                .forEach(tool -> structures.put(
                        tool,
                        NumberMatch.version(positions, NumberTable.named(tool)).structures()));
        return structures;
    }

    /** Returns a table in which a label without a known name that encloses all others is the skin, if none is. */
    private LabelTable withOutline(LabelVolume volume) {
        Map<Integer, String> all = new TreeMap<>(structures);
        if (!all.containsValue(SKIN)) {
            BodyOutline.label(volume.grid(), this).ifPresent(label -> all.put(label, SKIN));
        }
        return new LabelTable(all, missing);
    }

    /**
     * Returns a table that holds every label of the volume. A label without a structure is named after its name or
     * number: {@code other_NAME}, or {@code skin} if it encloses all others.
     */
    public LabelTable withRest(LabelVolume volume) {
        int[] counts = volume.grid().counts();
        Map<Integer, String> all = new TreeMap<>(structures);
        NamedLabels named = NamedLabels.of(volume);
        long names = structures.values().stream().distinct().count();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0 && !all.containsKey(label) && names++ < MAX_STRUCTURES) {
                String name = named.names().getOrDefault(label, "");
                String text = name.isBlank() ? String.valueOf(label) : name;
                all.put(label, named.structures().getOrDefault(label, OrganNames.other(text, label)));
            }
        }
        return new LabelTable(all, missing).withOutline(volume);
    }

    private static LabelTable of(String file, CsvTable table, LabelVolume volume) {
        List<String> structures = table.texts("structure");
        if (structures.isEmpty()) {
            throw new BadInputException(file + ": found no row, expected labels and their structures");
        }
        boolean byName = table.has("name") && !(volume.names().isEmpty() && table.has("label"));
        int[] counts = volume.grid().counts();
        Map<Integer, String> map = new TreeMap<>();
        List<String> absent = new ArrayList<>();
        for (int row = 0; row < structures.size(); row++) {
            requireStructure(table, row, structures);
            String structure = word(structures.get(row)).orElse(StructureName.usual(structures.get(row)));
            List<Integer> labels = byName
                    ? LabelRows.labels(volume.names(), table.texts("name"), row, structure)
                    : List.of(label(table, row));
            for (int label : labels) {
                String before = map.put(label, structure);
                if (before != null && !before.equals(structure)) {
                    throw table.badCell(
                            row,
                            byName ? "name" : "label",
                            "found label " + label + " for '" + structure + "' and, in a row above, for '" + before
                                    + "', expected one structure");
                }
            }
            if (labels.stream().noneMatch(label -> label < counts.length && counts[label] > 0)) {
                absent.add((byName ? "name '" + table.texts("name").get(row) + "'" : "label " + labels.get(0)) + " ("
                        + structure + ")");
            }
        }
        if (map.isEmpty()) {
            throw new BadInputException(file + ": found no row for a label of the volume, expected some");
        }
        LabelTable read = new LabelTable(map, absent);
        boolean fits = map.keySet().stream().anyMatch(label -> label < counts.length && counts[label] > 0);
        return fits ? read.withRest(volume) : read;
    }

    private static void requireStructure(CsvTable table, int row, List<String> structures) {
        String structure = structures.get(row);
        if (!isStructure(structure)) {
            throw table.badCell(
                    row,
                    "structure",
                    "found '" + structure + "', expected a structure such as rib_05_R, lung_L, liver, kidney_R,"
                            + " other_NAME, " + LUNGS + ", " + RIBS + ", " + RIGHT_RIBS + ", " + LEFT_RIBS + ", "
                            + COSTAL_CARTILAGES + " or " + IGNORE);
        }
        Optional<String> twin =
                structures.stream().filter(structure::equalsIgnoreCase).findFirst();
        if (!structure.equals(twin.orElse(structure))) {
            throw table.badCell(
                    row,
                    "structure",
                    "found '" + structure + "' besides '" + twin.get() + "', expected one spelling,"
                            + " because some systems take both for one file");
        }
    }

    private static int label(CsvTable table, int row) {
        double label = table.numbers("label")[row];
        if (label != (int) label || label < 1 || label > LabelGrid.MAX_LABEL) {
            throw table.badCell(
                    row,
                    "label",
                    "found " + table.texts("label").get(row) + ", expected a whole number from 1 to "
                            + LabelGrid.MAX_LABEL);
        }
        return (int) label;
    }

    /** Whether a structure is several ribs under one name, of both sides or of one. */
    public static boolean isRibs(String structure) {
        return structure.equals(RIBS) || structure.equals(RIGHT_RIBS) || structure.equals(LEFT_RIBS);
    }

    /** The name of all ribs of a side, right or left, under one label. */
    static String ribsOf(Side side) {
        return side == Side.RIGHT ? RIGHT_RIBS : LEFT_RIBS;
    }

    /** Whether a structure is an aid of a plan of radiotherapy. An import leaves it out. */
    public static boolean isOfPlan(String structure) {
        return structure.startsWith(OF_PLAN);
    }

    /** Whether a structure is several bones under one name, which are no pieces of each other. */
    public static boolean isSeveralBones(String structure) {
        return structure.equals(ALL_BONES) || structure.equals(SPINE);
    }

    /**
     * Whether a structure fills the space between organs and has no shape by itself: skin, muscle, fat and other
     * tissue. It is told by its name.
     */
    public static boolean fillsBetweenOrgans(String structure) {
        return StructureName.parse(structure)
                .map(StructureName::kind)
                .filter(kind -> switch (kind) {
                    case SKIN, MUSCLE -> true;
                    case OTHER ->
                        BETWEEN_ORGANS.matcher(structure).matches()
                                && !SHAPED.matcher(structure).matches();
                    default -> false;
                })
                .isPresent();
    }

    /** Whether a name can stand in the table: a structure, several under one label, or that a label is ignored. */
    public static boolean isStructure(String name) {
        return word(name).isPresent() || StructureName.parse(name).isPresent();
    }

    /** The word of the table that a name is in any case: several structures under one label, or {@link #IGNORE}. */
    private static Optional<String> word(String name) {
        return Stream.of(LUNGS, RIBS, RIGHT_RIBS, LEFT_RIBS, COSTAL_CARTILAGES, IGNORE)
                .filter(name::equalsIgnoreCase)
                .findFirst();
    }

    /**
     * The spelling of a structure's name by which other code finds it. A scan has one skin, also where it labels the
     * rind beside the body.
     */
    static String usual(String name) {
        boolean isSkin = StructureName.parse(name)
                .filter(parsed -> parsed.kind() == StructureKind.SKIN)
                .isPresent();
        return isSkin ? SKIN : word(name).orElseGet(() -> StructureName.usual(name.replace(' ', '_')));
    }
}
