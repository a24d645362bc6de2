package org.phrenic.simulation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Hashes;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.PvdSeries;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/**
 * Writes the output of a run: {@code summary.json}, {@code observables.csv}, {@code scenario.yaml} and, on request, a
 * mesh series {@code scene.pvd} with one {@code .vtp} per structure and time. Each file is written beside its target
 * and then moved over it. An earlier result in the folder stays as it is until this one is computed. The summary is
 * written last, so a folder with a summary is complete.
 */
final class RunRecorder {
    private static final String SUMMARY = "summary.json";
    private static final String SERIES = "scene.pvd";
    private static final String MESHES = "meshes";
    /** Folder of the meshes of a run that has not ended. */
    private static final String UNFINISHED = MESHES + ".part";
    /** Name of a mesh of a run: structure and number of the frame, of at least five digits. */
    private static final String FRAME_NAME = "%s_%05d.vtp";
    /** Names of {@link #FRAME_NAME}: structure, number of the frame. */
    private static final Pattern FRAME_NAMES = Pattern.compile("(.+)_(\\d{5,})\\.vtp");
    /** Tolerance for rounding when comparing output times. */
    private static final double ROUNDING = 1e-9;

    private final Scenario scenario;
    private final Simulation simulation;
    private final Path out;
    private final PvdSeries series;
    private SceneSurfaces surfaces;
    private int frame;
    /** Number of intervals after which the next meshes are due; whole. */
    private double due;

    RunRecorder(Scenario scenario, Simulation simulation, Path out) {
        this.scenario = scenario;
        this.simulation = simulation;
        this.out = out;
        boolean meshes = out != null && scenario.get(RunSettings.MESHES_EVERY) > 0;
        series = meshes ? new PvdSeries(out.resolve(SERIES)) : null;
        if (out != null) {
            replacing(this::deleteUnfinished);
        }
    }

    /** An action on files. */
    private interface FileAction {
        void run() throws IOException;
    }

    private void replacing(FileAction action) {
        try {
            action.run();
        } catch (IOException e) {
            throw new OutputException(out + ": an earlier result cannot be replaced: " + e.getMessage(), e);
        }
    }

    /** The folders in {@code out} into which a run writes meshes, and in which it deletes those of an earlier one. */
    static List<Path> meshFolders(Path out) {
        return List.of(out.resolve(MESHES), out.resolve(UNFINISHED));
    }

    private Path unfinished() {
        return out.resolve(UNFINISHED);
    }

    /**
     * Puts the meshes of this run in place of the results of an earlier one, which would not match the new files. They
     * are listed before they are moved, so that the next run finds and replaces them wherever this one is stopped.
     */
    private void replaceEarlierResults() throws IOException {
        Files.deleteIfExists(out.resolve(SUMMARY));
        deleteSeries();
        if (series == null) {
            return;
        }
        Files.createDirectories(out.resolve(MESHES));
        series.write();
        for (Path mesh : frames(unfinished())) {
            Files.move(mesh, out.resolve(MESHES).resolve(mesh.getFileName()));
        }
        deleteUnfinished();
    }

    /** Deletes the meshes that an earlier run has listed, then the list. */
    private void deleteSeries() throws IOException {
        Set<Path> listed = listed();
        for (Path mesh : frames(out.resolve(MESHES))) {
            if (listed.contains(mesh)) {
                Files.delete(mesh);
            }
        }
        Files.deleteIfExists(out.resolve(SERIES));
    }

    /** The meshes that an earlier run has listed. */
    private Set<Path> listed() {
        return new HashSet<>(PvdSeries.files(out.resolve(SERIES)));
    }

    /** Refuses to begin where a file that no run has listed has the name of one of the meshes. */
    private void requireNamesFree() {
        Set<String> structures = surfaces.surfaces().stream().map(Surface::name).collect(Collectors.toSet());
        long last = (long) (simulation.durationS() / intervalS()) + 1;
        Set<Path> listed = listed();
        for (Path mesh : frames(out.resolve(MESHES))) {
            Matcher name = FRAME_NAMES.matcher(mesh.getFileName().toString());
            if (!listed.contains(mesh)
                    && name.matches()
                    && structures.contains(name.group(1))
                    && Numbers.parseWhole(name.group(2), 0, last).isPresent()) {
                throw new BadInputException(
                        mesh + ": found a file that no run has listed in " + SERIES + ", expected its name to be free");
            }
        }
    }

    /** Deletes the meshes of a run that did not end, and their folder if nothing else is in it. */
    private void deleteUnfinished() throws IOException {
        for (Path mesh : frames(unfinished())) {
            Files.delete(mesh);
        }
        if (Files.isDirectory(unfinished()) && InputBytes.list(unfinished()).isEmpty()) {
            Files.delete(unfinished());
        }
    }

    /** The meshes of runs in a folder. */
    private static List<Path> frames(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        return InputBytes.list(folder).stream()
                .filter(file ->
                        FRAME_NAMES.matcher(file.getFileName().toString()).matches())
                .toList();
    }

    /** Number of steps of a length from a time until meshes are due, at least 1. */
    long stepsToMeshes(double time, double dt) {
        return series == null ? Long.MAX_VALUE : Math.max(1, (long) Math.ceil((dueS() - time) / dt));
    }

    /** Time from which the next meshes are due, s. */
    private double dueS() {
        return due * intervalS();
    }

    private double intervalS() {
        return scenario.get(RunSettings.MESHES_EVERY) * (1 - ROUNDING);
    }

    /** Called after a step; writes meshes if due. */
    void recordMeshes(double time) {
        if (series == null || time < dueS()) {
            return;
        }
        if (surfaces == null) {
            surfaces = new SceneSurfaces(simulation);
            requireNamesFree();
        }
        List<TriangleMesh> meshes = surfaces.meshes();
        for (int i = 0; i < meshes.size(); i++) {
            Surface surface = surfaces.surfaces().get(i);
            String file = Numbers.format(FRAME_NAME, surface.name(), frame);
            VtpWriter.write(unfinished().resolve(file), meshes.get(i), pointData(surface, meshes.get(i)));
            series.add(time, i, out.resolve(MESHES).resolve(file));
        }
        frame++;
        due = Math.max(due, Math.floor(time / intervalS())) + 1;
    }

    private static Map<String, double[]> pointData(Surface surface, TriangleMesh mesh) {
        if (surface.kind() != StructureKind.DIAPHRAGM) {
            return Map.of();
        }
        double[] displacement = mesh.positions().clone();
        for (int i = 0; i < displacement.length; i++) {
            displacement[i] -= surface.rest().positions()[i];
        }
        double[] tendon = new double[mesh.vertexCount()];
        Arrays.setAll(tendon, i -> surface.tendon()[i] ? 1 : 0);
        Map<String, double[]> data = new LinkedHashMap<>();
        data.put("displacement_mm", displacement);
        data.put("tendon", tendon);
        return data;
    }

    /** Writes the remaining files. */
    void writeResults(Map<String, Object> summary, List<Observation> samples) {
        if (out == null) {
            return;
        }
        replacing(this::replaceEarlierResults);
        CsvWriter.write(out.resolve("observables.csv"), Observation.COLUMNS, () -> samples.stream()
                .<List<?>>map(o -> DoubleStream.of(o.values()).boxed().toList())
                .iterator());
        YamlWriter.write(out.resolve("scenario.yaml"), scenario.toMap());
        Map<String, Object> all = new LinkedHashMap<>(summary);
        all.put("made_by", provenance());
        JsonWriter.write(out.resolve(SUMMARY), all);
    }

    /** Version, seed and hashes of the inputs. */
    private Map<String, Object> provenance() {
        Map<String, Object> map = new LinkedHashMap<>();
        String version = RunRecorder.class.getPackage().getImplementationVersion();
        map.put("phrenic", version == null ? "development" : version);
        map.put("java", System.getProperty("java.version"));
        map.put("seed", "none: nothing in a run is random");
        List<Object> inputs = new ArrayList<>();
        for (Structure s : simulation.scene().thorax().structures()) {
            Map<String, Object> one = new LinkedHashMap<>();
            one.put("structure", s.name());
            one.put("positions_sha256", Hashes.sha256(s.mesh().positions()));
            inputs.add(one);
        }
        map.put("inputs", inputs);
        return map;
    }
}
