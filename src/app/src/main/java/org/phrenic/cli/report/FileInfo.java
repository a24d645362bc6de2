package org.phrenic.cli.report;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.raster.VolumeFormats;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.patient.label.NamesBeside;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/** The output of {@code phrenic info} for a mesh, a label volume, a scenario or a thorax folder. */
public final class FileInfo {
    private static final int RIBS = 12;

    private FileInfo() {}

    /**
     * Properties of a file by key.
     *
     * @throws BadInputException if the file is of no supported kind; the message is one sentence
     */
    public static Map<String, Object> of(Path file) {
        if (!Files.exists(file) && !LabelVolumeFiles.isVolume(file)) {
            throw new BadInputException(
                    file + ": found no such file, expected a mesh, a volume, a scenario or a folder of meshes");
        }
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", file.toString());
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (Files.isDirectory(file) && !LabelVolumeFiles.isVolume(file)) {
            info.put("kind", "thorax");
            putThorax(info, ThoraxFolder.loadWholeOrPart(file));
            ScanInfo.putImport(info, file);
        } else if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            info.put("kind", "scenario");
            putScenario(info, Scenario.read(file), YamlDocument.read(file).keys());
        } else if (LabelVolumeFiles.isVolume(file)) {
            info.put("kind", "label volume");
            putVolume(info, NamesBeside.added(file, LabelVolumeFiles.read(file)));
        } else if (MeshFiles.isMesh(file)) {
            info.put("kind", "mesh");
            putMesh(info, MeshFiles.read(file));
        } else {
            throw new BadInputException(
                    file + ": found no mesh, volume, scenario or folder, expected a name that ends in yaml, "
                            + String.join(", ", MeshFiles.READABLE) + " or "
                            + String.join(", ", LabelVolumeFiles.READABLE)
                            + (VolumeFormats.isPacked(file) ? ": unpack it first" : ""));
        }
        return info;
    }

    /** Lengths are in the unit of the file, which mesh formats do not state. */
    private static void putMesh(Map<String, Object> info, TriangleMesh mesh) {
        MeshTopology topology = new MeshTopology(mesh);
        MeshMeasure.EdgeLengths edges = MeshMeasure.edgeLengthSummary(mesh, topology);
        long unused =
                mesh.vertexCount() - Arrays.stream(mesh.triangles()).distinct().count();
        List<Double> bounds = list(mesh.bounds());
        info.put("vertices", mesh.vertexCount());
        info.put("unused_vertices", unused);
        info.put("triangles", mesh.triangleCount());
        info.put("edges", topology.edgeCount());
        info.put("components", topology.componentCount() - unused);
        info.put("closed", topology.isClosed());
        info.put("manifold", topology.isManifold());
        info.put("boundary_loops", topology.boundaryLoops().size());
        info.put("euler_characteristic", topology.eulerCharacteristic());
        info.put("area", MeshMeasure.area(mesh));
        info.put("volume", topology.isClosed() ? MeshMeasure.signedVolume(mesh) : null);
        info.put("bounds_minimum", bounds.subList(0, 3));
        info.put("bounds_maximum", bounds.subList(3, 6));
        info.put("edge_length_minimum", edges.minimum());
        info.put("edge_length_mean", edges.mean());
        info.put("edge_length_maximum", edges.maximum());
        double angle = Arrays.stream(MeshMeasure.smallestAngles(mesh)).min().orElse(0);
        info.put("smallest_angle_deg", angle);
    }

    private static void putVolume(Map<String, Object> info, LabelVolume volume) {
        LabelGrid grid = volume.grid();
        double[] first = new double[3];
        double[] last = new double[3];
        grid.voxelToMm(0, 0, 0, first);
        grid.voxelToMm(grid.columns() - 1, grid.rows() - 1, grid.slices() - 1, last);
        info.put("voxels", List.of(grid.columns(), grid.rows(), grid.slices()));
        info.put("spacing_mm", List.of(grid.spacing(0), grid.spacing(1), grid.spacing(2)));
        info.put("first_voxel_lps_mm", list(first));
        info.put("last_voxel_lps_mm", list(last));
        Map<String, Object> labels = new LinkedHashMap<>();
        int[] counts = grid.counts();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0) {
                String name = volume.names().getOrDefault(label, "");
                labels.put((label + " " + name).strip(), grid.volumeMl(counts[label]));
            }
        }
        info.put("labels_ml", labels);
        ScanInfo.putLabels(info, volume);
        info.put("notes", volume.notes());
    }

    /** Every key with its value and the origin of the value: file, preset or program default. */
    private static void putScenario(Map<String, Object> info, Scenario scenario, Set<String> stated) {
        for (Setting<?> setting : Settings.all()) {
            Object value = setting == RunSettings.DURATION ? duration(scenario) : scenario.plain(setting);
            if (value != null) {
                boolean ofPreset =
                        setting == RunSettings.DURATION || (setting instanceof Parameter p && p.isGivenByPreset());
                boolean hasUnit =
                        setting instanceof Parameter || !setting.unit().equals("1");
                String from = stated.contains(setting.key()) ? "file" : ofPreset ? "preset" : "default";
                String unit = hasUnit ? setting.unit() : "";
                info.put(
                        setting.key(),
                        new OrderedValues()
                                .with("value", value)
                                .with("unit", unit)
                                .with("from", from));
            }
        }
    }

    /** Simulated time, s; null if a recording determines the duration. */
    private static Object duration(Scenario scenario) {
        if (!Double.isNaN(scenario.durationS()) || scenario.trace().isPresent()) {
            return scenario.plain(RunSettings.DURATION);
        }
        BreathingParameters breath = scenario.breathing().parameters().withRatePerMin(scenario.get(Breathing.RATE));
        return scenario.durationS(scenario.breathing().pattern(breath));
    }

    private static void putThorax(Map<String, Object> info, Thorax thorax) {
        Map<String, Object> counts = new LinkedHashMap<>();
        for (StructureKind kind : StructureKind.values()) {
            int count = thorax.structuresOf(kind).size();
            if (count > 0) {
                counts.put(kind.name().toLowerCase(Locale.ROOT), count);
            }
        }
        info.put("name", thorax.name());
        // The loader's first note states the axes and the unit of the folder, as declared or as inferred.
        info.put("frame", thorax.notes().get(0));
        info.put("structures", counts);
        IntStream triangles =
                thorax.structures().stream().mapToInt(s -> s.mesh().triangleCount());
        info.put("triangles", triangles.sum());
        info.put("missing", missing(thorax));
        info.put("notes", thorax.notes().subList(1, thorax.notes().size()));
    }

    private static List<String> missing(Thorax thorax) {
        List<String> missing = new ArrayList<>();
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            String suffix = side == Side.RIGHT ? "_R" : "_L";
            for (int level = 1; level <= RIBS; level++) {
                if (thorax.find(StructureKind.RIB, level, side).isEmpty()) {
                    missing.add(Numbers.format("rib_%02d%s", level, suffix));
                }
            }
            if (thorax.structuresOf(StructureKind.LUNG).stream().noneMatch(lung -> lung.side() == side)) {
                missing.add("lung" + suffix);
            }
        }
        for (StructureKind kind : List.of(
                StructureKind.DIAPHRAGM,
                StructureKind.STERNUM,
                StructureKind.COSTAL_CARTILAGE,
                StructureKind.VERTEBRA,
                StructureKind.LIVER,
                StructureKind.SKIN)) {
            if (thorax.structuresOf(kind).isEmpty()) {
                missing.add(kind.name().toLowerCase(Locale.ROOT));
            }
        }
        return missing;
    }

    private static List<Double> list(double[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }

    /** The result of {@link #of} as text: a heading, then one line per value. */
    public static String text(Map<String, Object> info) {
        StringBuilder text = new StringBuilder(info.get("file") + ": " + info.get("kind") + "\n");
        TextTable[] table = {new TextTable(false, false, false)};
        info.forEach((key, value) -> {
            List<String> lines = lines(value);
            if (!lines.isEmpty()) {
                // Sentences would widen the columns.
                text.append(table[0].text()).append("  ").append(key).append('\n');
                lines.forEach(line -> text.append("    ").append(line).append('\n'));
                table[0] = new TextTable(false, false, false);
            } else if (!key.equals("file") && !key.equals("kind") && !key.equals("labels_ml")) {
                // The rows of labels state their volumes too.
                append(table[0], "  " + key, value);
            }
        });
        return text.append(table[0].text()).toString();
    }

    /** A list of sentences or of labels as lines; empty for any other value. */
    private static List<String> lines(Object value) {
        return value instanceof List<?> list && list.stream().anyMatch(i -> i instanceof String || i instanceof Map)
                ? list.stream()
                        .map(item -> item instanceof Map<?, ?> label ? ScanInfo.line(label) : item.toString())
                        .toList()
                : List.of();
    }

    private static void append(TextTable table, String label, Object value) {
        if (value instanceof Map<?, ?> map && map.containsKey("from")) {
            String unit = map.get("unit").equals("1") ? "" : " " + map.get("unit");
            table.row(label, QuantityKey.format(map.get("value")) + unit, String.valueOf(map.get("from")));
        } else if (value instanceof Map<?, ?> map) {
            table.row(label, "", "");
            map.forEach((key, item) -> append(table, "  " + label.substring(0, 2) + key, item));
        } else if (value instanceof List<?> list) {
            String items = list.stream().map(QuantityKey::format).collect(Collectors.joining("  "));
            table.row(label, items.isEmpty() ? "none" : items, "");
        } else {
            table.row(label, value == null ? "-" : QuantityKey.format(value), "");
        }
    }
}
