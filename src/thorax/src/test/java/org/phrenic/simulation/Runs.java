package org.phrenic.simulation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.ComputedArrays;
import org.phrenic.file.UnfinishedFiles;
import org.phrenic.file.UserCache;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.model.assembly.BreathDrive;
import org.phrenic.model.assembly.LiveBreathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.material.SceneAssembly;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.RampedValues;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.SceneObserver;

/** Simulations of the coarse virtual adult male that several tests look at, each computed once. */
public final class Runs {
    /**
     * Sheet alone among what is stepped: the diaphragm does in it what it does in the whole scene, at half the price.
     */
    public static final String[] SHEET_ALONE = {"lungs=embedded", "sternum=kinematic"};

    private static final double SAMPLE_S = 0.05;
    /** Settled scenes of this process, which have the bits of computed ones. */
    private static final UserCache SETTLED = settled();

    private static final Map<String, Run> DONE = new ConcurrentHashMap<>();

    private Runs() {}

    private static UserCache settled() {
        try {
            Path folder = Files.createTempDirectory("phrenic-settled");
            UnfinishedFiles.add(folder);
            return UserCache.in(folder, "tests");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The scene of a scenario with the virtual adult male as finely meshed as it says, settled once for all tests. */
    public static Simulation simulation(Scenario scenario) {
        return Simulation.of(scenario, male(scenario), SETTLED);
    }

    /** The scene of a scenario, assembled and not settled, on one thread. */
    public static Scene assembled(Scenario scenario, Thorax body) {
        try (Workers workers = Workers.of(1)) {
            return SceneAssembly.assemble(
                    scenario,
                    body,
                    new RampedValues(scenario),
                    new BreathDrive(new LiveBreathing(scenario)),
                    RibCage.of(body, RibAxisTable.preset(RibAxisTable.WILSON_CT), true),
                    workers,
                    ComputedArrays.none());
        }
    }

    private static Thorax male(Scenario scenario) {
        return VirtualThorax.ofPreset("adult-male", OrganSettings.budget(scenario));
    }

    /** What was seen of a run, and what was in it. */
    record Run(List<Observation> seen, int nodes, int springs, int links, int attachments, int substeps) {

        Observation last() {
            return seen.get(seen.size() - 1);
        }

        /** Farthest that a column fell below its start. */
        double fall(String column) {
            return seen.get(0).get(column)
                    - seen.stream().mapToDouble(o -> o.get(column)).min().orElseThrow();
        }

        /** Farthest that a column rose above its start. */
        double rise(String column) {
            return seen.stream().mapToDouble(o -> o.get(column)).max().orElseThrow()
                    - seen.get(0).get(column);
        }

        double most(String column) {
            return seen.stream().mapToDouble(o -> Math.abs(o.get(column))).max().orElseThrow();
        }
    }

    public static Thorax male() {
        return VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    }

    /** A body whose sheet is remeshed, so that its two faces are meshed apart. */
    public static Thorax withRemeshedSheet(Thorax body, int vertices) {
        List<Structure> structures = body.structures().stream()
                .map(s -> s.kind() == StructureKind.DIAPHRAGM
                        ? s.withMesh(Remesher.toVertexCount(s.mesh(), vertices))
                        : s)
                .toList();
        return new Thorax(body.name(), structures, body.notes());
    }

    public static Scenario scenario(String... assignments) {
        return Scenario.defaults().with("resolution=low").with(assignments);
    }

    public static String[] sheetAlone(String... more) {
        String[] all = Arrays.copyOf(SHEET_ALONE, SHEET_ALONE.length + more.length);
        System.arraycopy(more, 0, all, SHEET_ALONE.length, more.length);
        return all;
    }

    /** A run of the coarse virtual adult male. */
    static Run of(double seconds, String... assignments) {
        Scenario scenario = scenario(assignments);
        return DONE.computeIfAbsent(
                seconds + Arrays.toString(assignments), key -> run(seconds, scenario, male(scenario)));
    }

    static Run run(double seconds, Scenario scenario, Thorax thorax) {
        try (Simulation simulation = Simulation.of(scenario, thorax, SETTLED)) {
            SceneObserver observer = new SceneObserver(simulation.scene());
            List<Observation> seen = new ArrayList<>();
            seen.add(observer.observe(0));
            long every = Math.max(1, Math.round(SAMPLE_S / scenario.timeStepS()));
            long steps = Math.round(seconds / scenario.timeStepS());
            for (long i = 1; i <= steps; i++) {
                simulation.step();
                if (i % every == 0 || i == steps) {
                    seen.add(observer.observe(simulation.time()));
                }
            }
            Scene scene = simulation.scene();
            return new Run(
                    seen,
                    scene.system().nodeCount(),
                    scene.springCount(),
                    scene.activeLinks().map(l -> l.count()).orElse(0),
                    scene.heldNodes().length,
                    simulation.stepper().substeps());
        }
    }
}
