package org.phrenic.study.regression;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.UnknownObservables;

/** Regression scenes and exercises with stored references, either those of the program or those of a folder. */
public class Regression {
    private static final String LIST = "scenes.yaml";

    private final Path folder;
    private final List<RegressionScene> scenes;
    private final List<RegressionAttempt> attempts;
    private final Function<Scenario, Thorax> bodies;
    private final Map<String, Thorax> bodyCache = new LinkedHashMap<>();

    /**
     * @param folder of references; null for those distributed with the program
     * @throws BadInputException with one sentence, if the list of scenes is invalid
     */
    public Regression(Path folder) {
        this(folder, shippedList(), shippedAttempts(), SimulationRun::loadThorax);
    }

    /**
     * @param scenes to compute
     * @param attempts to perform
     * @param bodies supplies the body of a scene
     */
    Regression(
            Path folder,
            List<RegressionScene> scenes,
            List<RegressionAttempt> attempts,
            Function<Scenario, Thorax> bodies) {
        this.folder = folder;
        this.scenes = List.copyOf(scenes);
        this.attempts = List.copyOf(attempts);
        this.bodies = bodies;
    }

    static List<RegressionScene> shippedList() {
        return RegressionScene.list(shipped(LIST));
    }

    static List<RegressionAttempt> shippedAttempts() {
        return RegressionAttempt.list(shipped(LIST), shippedList());
    }

    private static YamlMap shipped(String name) {
        return ShippedFile.find("regression/" + name)
                .map(text -> YamlDocument.parse(name, text))
                .orElseThrow(() -> new BadInputException(
                        name + ": found no such file in the program, expected references of this scene"
                                + " (phrenic regress --write-references data/regression makes them)"));
    }

    /**
     * A scene or an attempt.
     *
     * @param check reads the references and returns the comparison to run
     * @param values computes the references
     */
    private record Entry(
            String name, Supplier<Supplier<RegressionComparison>> check, Supplier<Map<String, Object>> values) {}

    private List<Entry> entries() {
        List<Entry> entries = new ArrayList<>();
        for (RegressionScene scene : scenes) {
            Supplier<Supplier<RegressionComparison>> check = () -> {
                RegressionReference stored = reference(scene);
                return () -> compare(scene, stored);
            };
            entries.add(new Entry(scene.name(), check, () -> compute(scene).values()));
        }
        for (RegressionAttempt attempt : attempts) {
            Supplier<Supplier<RegressionComparison>> check = () -> {
                Map<String, String> stored = attempt.read(stored(attempt.name()));
                return () -> compare(attempt, stored);
            };
            entries.add(
                    new Entry(attempt.name(), check, () -> attempt.values(attempt.compute(body(attempt.scenario())))));
        }
        return entries;
    }

    /** Names of all scenes and attempts, in order. */
    public List<String> names() {
        return entries().stream().map(Entry::name).toList();
    }

    private List<Entry> selected(List<String> only) {
        for (String name : only) {
            if (!names().contains(name)) {
                throw new BadInputException("--scene: found '" + name + "', expected " + String.join(", ", names()));
            }
        }
        return entries().stream()
                .filter(entry -> only.isEmpty() || only.contains(entry.name()))
                .toList();
    }

    /**
     * Computes scenes and attempts and compares them with their references. All references are read before the first
     * computation. What diverges or cannot be computed fails with the sentence that says why; the others are compared.
     *
     * @param only names of scenes and attempts; empty for all
     * @throws BadInputException with one sentence, if a reference file is missing, invalid or belongs to another scene
     */
    public List<RegressionComparison> check(List<String> only, ProgressListener progress) {
        List<Entry> selected = selected(only);
        List<Supplier<RegressionComparison>> checks =
                selected.stream().map(entry -> entry.check().get()).toList();
        List<RegressionComparison> comparisons = new ArrayList<>();
        for (Supplier<RegressionComparison> check : checks) {
            String name = selected.get(comparisons.size()).name();
            comparisons.add(check.get());
            progress.done(comparisons.size(), checks.size(), name);
        }
        return comparisons;
    }

    /** Computes scenes and attempts and writes the results as references into the folder. */
    public void write(List<String> only, ProgressListener progress) {
        int done = 0;
        List<Entry> selected = selected(only);
        for (Entry entry : selected) {
            YamlWriter.write(file(entry.name()), entry.values().get());
            progress.done(++done, selected.size(), entry.name());
        }
    }

    private Path file(String name) {
        return folder.resolve(name + ".yaml");
    }

    private YamlMap stored(String name) {
        return folder == null ? shipped(name + ".yaml") : YamlDocument.read(file(name));
    }

    final RegressionReference reference(RegressionScene scene) {
        return RegressionReference.read(stored(scene.name()), scene);
    }

    private RegressionComparison compare(RegressionAttempt attempt, Map<String, String> then) {
        try {
            return attempt.compare(then, attempt.compute(body(attempt.scenario())));
        } catch (DivergenceException | BadInputException | IllegalArgumentException failed) {
            return RegressionComparison.ofReport(attempt.name(), false, "", Double.NaN, failed.getMessage());
        }
    }

    private RegressionComparison compare(RegressionScene scene, RegressionReference then) {
        try {
            return RegressionComparison.of(scene, then, compute(scene));
        } catch (DivergenceException | BadInputException | IllegalArgumentException failed) {
            return RegressionComparison.failed(scene, failed.getMessage());
        }
    }

    /** The body of a scene, generated once and cached. */
    private Thorax body(Scenario scenario) {
        return bodyCache.computeIfAbsent(
                scenario.anatomy() + " " + OrganSettings.budget(scenario).vertices(), key -> bodies.apply(scenario));
    }

    /** Hook before the first step of every simulation, for tests. */
    void prepare(Simulation simulation) {}

    /** Computes a scene. */
    final RegressionReference compute(RegressionScene scene) {
        Scenario scenario = scene.scenario();
        try (Simulation simulation = Simulation.of(scenario, body(scenario))) {
            prepare(simulation);
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            int inAll = simulation.system().nodeCount();
            int[] kept = RegressionReference.sampledNodes(inAll);
            List<RegressionReference.Frame> frames = new ArrayList<>();
            for (double time : scene.timesS()) {
                while (simulation.time() < time - 0.5 * simulation.stepper().dt()) {
                    simulation.step();
                }
                frames.add(new RegressionReference.Frame(time, positions(simulation, kept), surfaces.observe()));
            }
            return new RegressionReference(
                    scene.specification(), inAll, kept, frames, UnknownObservables.of(simulation.scene()));
        }
    }

    private static double[] positions(Simulation simulation, int[] nodes) {
        double[] out = new double[3 * nodes.length];
        double[] one = new double[3];
        for (int i = 0; i < nodes.length; i++) {
            simulation.system().position(nodes[i], one);
            System.arraycopy(one, 0, out, 3 * i, 3);
        }
        return out;
    }
}
