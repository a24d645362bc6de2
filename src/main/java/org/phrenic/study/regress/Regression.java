package org.phrenic.study.regress;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.format.BadInputException;
import org.phrenic.format.YamlDocument;
import org.phrenic.format.YamlMap;
import org.phrenic.format.YamlWriter;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.StudyProgress;

/** The list of scenes with their references: those that come with the program, or those of a folder. */
public class Regression {
    private static final String SHIPPED = "/org/phrenic/data/regression/";
    private static final String LIST = "scenes.yaml";

    private final Path folder;
    private final List<RegressionScene> scenes;
    private final Function<Scenario, Thorax> bodies;
    private final Map<String, Thorax> grown = new LinkedHashMap<>();

    /**
     * @param folder of references; null for those that come with the program
     * @throws BadInputException with one sentence, if the list of scenes is not as it should be
     */
    public Regression(Path folder) {
        this(folder, shippedList(), SimulationRun::thorax);
    }

    /**
     * @param scenes to compute
     * @param bodies gives the body of a scene
     */
    Regression(Path folder, List<RegressionScene> scenes, Function<Scenario, Thorax> bodies) {
        this.folder = folder;
        this.scenes = List.copyOf(scenes);
        this.bodies = bodies;
    }

    static List<RegressionScene> shippedList() {
        return RegressionScene.list(shipped(LIST));
    }

    private static YamlMap shipped(String name) {
        try (InputStream in = Regression.class.getResourceAsStream(SHIPPED + name)) {
            if (in == null) {
                throw new BadInputException(name + ": found no such file in the program, expected references of this"
                        + " scene (phrenic regress --write-references data/regression makes them)");
            }
            return YamlDocument.read(name, in);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Names of all scenes, in order. */
    public List<String> names() {
        return scenes.stream().map(RegressionScene::name).toList();
    }

    /**
     * Computes scenes and compares them with their references.
     *
     * @param only names of scenes; empty for all
     * @throws BadInputException with one sentence, if a file of references is missing, broken or of another scene; before anything is computed
     */
    public List<Comparison> check(List<String> only, StudyProgress progress) {
        List<RegressionScene> asked = asked(only);
        List<Reference> then = asked.stream().map(this::reference).toList();
        List<Comparison> comparisons = new ArrayList<>();
        for (int i = 0; i < asked.size(); i++) {
            comparisons.add(compare(asked.get(i), then.get(i)));
            progress.done(i + 1, asked.size(), asked.get(i).name());
        }
        return comparisons;
    }

    /** Computes scenes and writes what they give as references into the folder. */
    public void write(List<String> only, StudyProgress progress) {
        List<RegressionScene> asked = asked(only);
        for (int i = 0; i < asked.size(); i++) {
            YamlWriter.write(file(asked.get(i)), compute(asked.get(i)).values());
            progress.done(i + 1, asked.size(), asked.get(i).name());
        }
    }

    private List<RegressionScene> asked(List<String> only) {
        for (String name : only) {
            if (!names().contains(name)) {
                throw new BadInputException("--scene: found '" + name + "', expected " + String.join(", ", names()));
            }
        }
        return scenes.stream()
                .filter(s -> only.isEmpty() || only.contains(s.name()))
                .toList();
    }

    private Path file(RegressionScene scene) {
        return folder.resolve(scene.name() + ".yaml");
    }

    final Reference reference(RegressionScene scene) {
        YamlMap yaml = folder == null ? shipped(scene.name() + ".yaml") : YamlDocument.read(file(scene));
        return Reference.read(yaml, scene);
    }

    private Comparison compare(RegressionScene scene, Reference then) {
        try {
            return Comparison.of(scene, then, compute(scene));
        } catch (DivergenceException told) {
            return Comparison.failed(scene, told.getMessage());
        } catch (BadInputException broken) {
            throw broken;
        } catch (IllegalArgumentException refused) {
            return Comparison.failed(scene, refused.getMessage());
        }
    }

    /** Told of every simulation before its first step: nothing is done to it but by tests. */
    void prepare(Simulation simulation) {}

    /** What a scene gives now. */
    final Reference compute(RegressionScene scene) {
        Scenario scenario = scene.scenario();
        Thorax thorax =
                grown.computeIfAbsent(scenario.anatomy() + " " + scenario.resolution(), key -> bodies.apply(scenario));
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            prepare(simulation);
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            int inAll = simulation.system().nodeCount();
            int[] kept = Reference.keptOf(inAll);
            List<Reference.Frame> frames = new ArrayList<>();
            for (double time : scene.timesS()) {
                while (simulation.time() < time - 0.5 * simulation.stepper().dt()) {
                    simulation.step();
                }
                frames.add(new Reference.Frame(time, positions(simulation, kept), surfaces.observe()));
            }
            return new Reference(scene.line(), inAll, kept, frames);
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
