package org.phrenic.patient.label;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.raster.VolumeSource;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;

/**
 * Names that lie beside a volume without names: label descriptions of ITK-SNAP or a colour table under the volume's own
 * name, else {@code dataset.json} of nnU-Net in its folder or, if that is called after labels, in the one above.
 */
public final class NamesBeside {
    private static final String DATA_SET = "dataset.json";
    /** A text of this size is no list of names. */
    private static final long MOST_BYTES = 1 << 24;

    private static final List<String> ENDINGS = List.of(".txt", ".label", ".ctbl");
    private static final Pattern VOLUME = Pattern.compile("(?i)(\\.seg)?\\.(nii(\\.gz)?|nrrd|nhdr|mha|mhd)$");

    private NamesBeside() {}

    /**
     * The volume with the names of the first such file that names each of its labels, and one of them as a structure;
     * unchanged if it has names or there is no such file. A note tells each file that is taken or left aside.
     *
     * @param named the file or folder of the volume; the masks of a folder are numbered as their files come
     */
    public static LabelVolume added(Path named, LabelVolume volume) {
        return withNames(named, volume, Optional.empty());
    }

    /**
     * The same for an import: names are added where no table is asked for ({@code --labels}), or one of names alone
     * that has none of the volume's own. Such a table tells the structures of names that are unknown without it.
     *
     * @param asked tool, data set or file
     */
    public static LabelVolume added(Path named, LabelVolume volume, Optional<String> asked) {
        if (asked.isEmpty()) {
            return added(named, volume);
        }
        return LabelRows.ofNamesAlone(asked.get())
                .filter(table -> !LabelRows.anyNames(table, volume.names()))
                .map(table -> withNames(named, volume, Optional.of(table)))
                .orElse(volume);
    }

    /** @param table the table of names that is asked for */
    private static LabelVolume withNames(Path named, LabelVolume volume, Optional<CsvTable> table) {
        Path file = volume.file()
                .orElseGet(() -> VolumeSource.of(named).path())
                .toAbsolutePath()
                .normalize();
        boolean ofMasks = Files.isDirectory(file) && !volume.names().isEmpty();
        if (ofMasks || !volume.names().values().stream().allMatch(LabelVolume::isNumber) || volume.isImage()) {
            return volume;
        }
        List<String> notes = new ArrayList<>(volume.notes());
        for (Path beside : candidates(file)) {
            Optional<Map<Integer, String>> names;
            try {
                names = NameFile.beside(beside);
            } catch (BadInputException unreadable) {
                notes.add(unreadable.getMessage() + "; it is left aside");
                continue;
            }
            if (names.isPresent()) {
                LabelVolume renamed = new LabelVolume(volume.grid(), names.get(), notes);
                Optional<String> problem = withoutName(renamed)
                        .or(() -> unknown(renamed, table))
                        .or(() -> byNumbers(renamed, beside.endsWith(DATA_SET), table.isEmpty()));
                notes.add(beside.getFileName()
                        + problem.map(why -> " is left aside: " + why).orElse(" names the labels"));
                if (problem.isEmpty()) {
                    return new LabelVolume(volume.grid(), names.get(), notes);
                }
            }
        }
        return new LabelVolume(volume.grid(), volume.names(), notes);
    }

    private static Optional<String> withoutName(LabelVolume named) {
        int[] counts = named.grid().counts();
        List<String> without = IntStream.range(1, counts.length)
                .filter(label -> counts[label] > 0 && !named.names().containsKey(label))
                .mapToObj(String::valueOf)
                .toList();
        return without.isEmpty()
                ? Optional.empty()
                : Optional.of("it has no name for label " + without.get(0)
                        + (without.size() > 1 ? " and " + (without.size() - 1) + " others" : ""));
    }

    private static Optional<String> unknown(LabelVolume named, Optional<CsvTable> table) {
        if (table.isPresent()) {
            return LabelRows.anyNames(table.get(), named.names())
                    ? Optional.empty()
                    : Optional.of("it has no name of the table");
        }
        return NamedLabels.of(named).areKnown()
                ? Optional.empty()
                : Optional.of("it has no name of a structure for a label of the volume");
    }

    /**
     * Why the labels are told by their numbers: they are those of a tool, and the names are those of a data set of
     * another task, or tell fewer of the labels.
     *
     * @param alone whether no table tells more names
     */
    private static Optional<String> byNumbers(LabelVolume named, boolean ofDataSet, boolean alone) {
        Map<Integer, String> structures = NamedLabels.of(named).structures();
        NumberMatch numbers = NumberMatch.best(NumberMatch.positions(named.grid()), NumberTable.ALL);
        String tool = numbers.table().title();
        if (ofDataSet && numbers.contradicts(named.grid(), structures)) {
            return Optional.of("labels lie as those of " + tool + " and not as those that it names");
        }
        return alone && numbers.tellsMoreThan(structures)
                ? Optional.of("labels are numbered as those of " + tool + ", and it names fewer structures")
                : Optional.empty();
    }

    private static List<Path> candidates(Path file) {
        Path folder = Files.isDirectory(file) ? file : file.getParent();
        List<Path> all = new ArrayList<>();
        if (!folder.equals(file)) {
            String stem = VOLUME.matcher(String.valueOf(file.getFileName())).replaceAll("");
            ENDINGS.forEach(ending -> all.add(folder.resolve(stem + ending)));
        }
        all.add(folder.resolve(DATA_SET));
        if (LabelVolumeFiles.isCalledLabels(folder)) {
            all.add(folder.resolveSibling(DATA_SET));
        }
        return all.stream()
                .filter(path -> Files.isRegularFile(path) && path.toFile().length() < MOST_BYTES)
                .toList();
    }
}
