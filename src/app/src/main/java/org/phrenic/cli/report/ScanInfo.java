package org.phrenic.cli.report;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.patient.label.LabelGuess;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.label.StatedAxes;

/** What {@code phrenic info} says of scans: the labels of a volume, and the import that made a thorax folder. */
final class ScanInfo {
    private static final String IMPORT_FILE = "import.json";
    private static final String SCAN = "scan";

    private ScanInfo() {}

    /** Adds the axes of a volume and its labels with their names, guessed structures and sizes. */
    static void putLabels(Map<String, Object> info, LabelVolume volume) {
        LabelGuess guess = LabelGuess.of(volume);
        Map<Integer, String> structures =
                guess.table().map(LabelTable::structures).orElse(Map.of());
        int[] counts = volume.grid().counts();
        List<Object> labels = new ArrayList<>();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0) {
                labels.add(new OrderedValues()
                        .with("label", label)
                        .with("name", volume.names().getOrDefault(label, ""))
                        .with("structure", structures.getOrDefault(label, ""))
                        .with("voxels", counts[label])
                        .with("ml", volume.grid().volumeMl(counts[label])));
            }
        }
        info.put("axes", StatedAxes.letters(volume));
        guess.table()
                .flatMap(table -> StatedAxes.contradicted(volume, table, Optional.empty()))
                .ifPresent(axes -> info.put("axes_contradicted", axes.sentence()));
        info.put("label_table", guess.reason());
        info.put("labels", labels);
    }

    /** One label of {@link #putLabels} as text. */
    static String line(Map<?, ?> label) {
        String name = String.valueOf(label.get("name"));
        String structure = String.valueOf(label.get("structure"));
        return Numbers.format(
                "%3s %s%s, %s voxels, %s ml",
                label.get("label"),
                structure.isEmpty() ? "unknown" : structure,
                name.isEmpty() || name.equals(structure) ? "" : " (" + name + ")",
                label.get("voxels"),
                QuantityKey.format(label.get("ml")));
    }

    /** Adds the sources and notes of an imported thorax folder; nothing if no import made it. */
    static void putImport(Map<String, Object> info, Path folder) {
        Path file = folder.resolve(IMPORT_FILE);
        if (!Files.isRegularFile(file)) {
            return;
        }
        YamlMap report = YamlDocument.read(file);
        Map<String, List<String>> bySource = new TreeMap<>();
        for (YamlMap structure : report.maps("structures")) {
            bySource.computeIfAbsent(structure.text("source", SCAN), source -> new ArrayList<>())
                    .add(structure.text("structure"));
        }
        Map<String, Object> sources = new LinkedHashMap<>();
        bySource.forEach((source, names) -> sources.put(
                source,
                source.equals(SCAN) ? names.size() + " structures" : String.join(", ", NameRanges.collapse(names))));
        info.put("imported_from", report.text("volume", ""));
        info.put("sources", sources);
        info.put("import_notes", report.texts("notes"));
    }
}
