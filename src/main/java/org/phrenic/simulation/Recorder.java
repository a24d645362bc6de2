package org.phrenic.simulation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.anatomy.BlendedMotion;
import org.phrenic.anatomy.BoneWeights;
import org.phrenic.anatomy.RibCagePose;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.format.CsvWriter;
import org.phrenic.format.Hashes;
import org.phrenic.format.Json;
import org.phrenic.format.OutputException;
import org.phrenic.format.PvdSeries;
import org.phrenic.format.VtpWriter;
import org.phrenic.format.YamlWriter;
import org.phrenic.geometry.TriangleMesh;

/**
 * Writes what a run leaves behind: {@code summary.json}, {@code observables.csv}, {@code scenario.yaml} and, if asked for, a series of meshes {@code scene.pvd} with one {@code .vtp} a structure and time. Each
 * file is written beside its target and moved over it; summary last, so that a folder with a summary is complete.
 */
final class Recorder {
    private static final String SUMMARY = "summary.json";

    private final Scenario scenario;
    private final Simulation simulation;
    private final Path out;
    private final long meshEvery;
    private final PvdSeries series;
    private final Map<String, BlendedMotion> cartilages = new HashMap<>();
    private BoneWeights bones;
    private int frame;

    Recorder(Scenario scenario, Simulation simulation, Path out) {
        this.scenario = scenario;
        this.simulation = simulation;
        this.out = out;
        boolean meshes = out != null && scenario.meshesEveryS() > 0;
        meshEvery = meshes ? Math.max(1, Math.round(scenario.meshesEveryS() / scenario.timeStepS())) : 0;
        series = meshes ? new PvdSeries(out.resolve("scene.pvd")) : null;
        if (out != null) {
            removeEarlier(out.resolve(SUMMARY));
        }
    }

    /** A summary of an earlier run must not stand beside what this one writes, should this one fail. */
    private static void removeEarlier(Path summary) {
        try {
            Files.deleteIfExists(summary);
        } catch (IOException e) {
            throw new OutputException(summary + ": cannot be replaced: " + e.getMessage(), e);
        }
    }

    /** Told after steps; writes meshes if it is time. */
    void at(long step, double time, Observer observer) {
        if (meshEvery == 0 || step < frame * meshEvery) {
            return;
        }
        Scene scene = simulation.scene();
        double[] now = new double[scene.rest().length];
        scene.system().layout().toCaller(scene.system().positions(), now);
        int part = 0;
        for (Map.Entry<String, TriangleMesh> entry :
                surfaces(scene, observer, time, now).entrySet()) {
            Path file = out.resolve("meshes").resolve(String.format(Locale.ROOT, "%s_%05d.vtp", entry.getKey(), frame));
            VtpWriter.write(file, entry.getValue(), pointData(scene, entry.getKey(), now));
            series.add(time, part++, file);
        }
        frame++;
    }

    private static Map<String, double[]> pointData(Scene scene, String name, double[] now) {
        if (!name.equals("diaphragm")) {
            return Map.of();
        }
        DiaphragmPart part = scene.diaphragm();
        int n = part.diaphragm.sheet().vertexCount();
        double[] displacement = new double[3 * n];
        double[] tendon = new double[n];
        for (int i = 0; i < 3 * n; i++) {
            displacement[i] = now[3 * part.first + i] - scene.rest()[3 * part.first + i];
            tendon[i / 3] = part.diaphragm.isTendon(i / 3) ? 1 : 0;
        }
        Map<String, double[]> data = new LinkedHashMap<>();
        data.put("displacement_mm", displacement);
        data.put("tendon", tendon);
        return data;
    }

    /** Every surface of the scene as it stands. */
    private Map<String, TriangleMesh> surfaces(Scene scene, Observer observer, double time, double[] now) {
        Map<String, TriangleMesh> map = new LinkedHashMap<>();
        DiaphragmPart d = scene.diaphragm();
        map.put("diaphragm", nodes(d.diaphragm.sheet(), d.first, now));
        scene.sternum().ifPresent(s -> {
            for (int i = 0; i < s.structures.size(); i++) {
                Structure structure = s.structures.get(i);
                map.put(structure.name(), nodes(structure.mesh(), s.firsts.get(i), now));
            }
        });
        List<Structure> lungs = observer.lungs().structures();
        for (int i = 0; i < lungs.size(); i++) {
            map.put(
                    lungs.get(i).name(),
                    lungs.get(i).mesh().withPositions(observer.lungs().positions(i, time, scene.rest(), now)));
        }
        scene.liver()
                .ifPresent(l ->
                        map.put(l.structure.name(), l.structure.mesh().withPositions(l.positions(scene.rest(), now))));
        for (Structure s : scene.thorax().structures()) {
            if (!map.containsKey(s.name())) {
                map.put(
                        s.name(),
                        s.kind() == StructureKind.COSTAL_CARTILAGE ? blended(s, time) : rigid(s, scene.pose()));
            }
        }
        return map;
    }

    private static TriangleMesh nodes(TriangleMesh mesh, int first, double[] now) {
        double[] p = new double[mesh.positions().length];
        System.arraycopy(now, 3 * first, p, 0, p.length);
        return mesh.withPositions(p);
    }

    /** A cartilage that is no mass-spring system bends between its rib and the sternum. */
    private TriangleMesh blended(Structure s, double time) {
        Scene scene = simulation.scene();
        if (bones == null) {
            bones = BoneWeights.of(scene.thorax(), scene.pose().cage());
        }
        BlendedMotion motion = cartilages.computeIfAbsent(
                s.name(),
                name -> new BlendedMotion(
                        scene.pose(),
                        s.mesh().positions(),
                        bones.at(s.mesh().positions()),
                        scene.system().workers()));
        double[] p = new double[s.mesh().positions().length];
        motion.at(time, p, new double[p.length]);
        return s.mesh().withPositions(p);
    }

    private static TriangleMesh rigid(Structure s, RibCagePose pose) {
        int body = -1;
        if (s.kind() == StructureKind.RIB) {
            body = pose.cage().rib(s.level(), s.side());
        } else if (s.kind() == StructureKind.STERNUM) {
            body = pose.cage().sternum();
        }
        if (body <= 0) {
            return s.mesh();
        }
        double[] p = new double[s.mesh().positions().length];
        HelicalBody.move(pose.pose(body), s.mesh().positions(), 0, p, 0, p.length / 3);
        return s.mesh().withPositions(p);
    }

    /** Writes everything that is left. */
    void finish(Map<String, Object> summary, List<Observation> samples) {
        if (out == null) {
            return;
        }
        Map<String, double[]> columns = new LinkedHashMap<>();
        for (int c = 0; c < Observation.COLUMNS.size(); c++) {
            int column = c;
            columns.put(
                    Observation.COLUMNS.get(c),
                    samples.stream().mapToDouble(o -> o.values()[column]).toArray());
        }
        CsvWriter.write(out.resolve("observables.csv"), columns, CsvWriter.ALL_DIGITS);
        YamlWriter.write(out.resolve("scenario.yaml"), scenario.toMap());
        if (series != null) {
            series.write();
        }
        Map<String, Object> all = new LinkedHashMap<>(summary);
        all.put("made_by", madeBy());
        Json.write(out.resolve(SUMMARY), all);
    }

    /** Version, seed and hashes of what went in. */
    private Map<String, Object> madeBy() {
        Map<String, Object> map = new LinkedHashMap<>();
        String version = Recorder.class.getPackage().getImplementationVersion();
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
