package org.phrenic.scenario;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Resolution;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.simulation.organ.LungModel;
import org.phrenic.simulation.organ.SternumModel;
import org.phrenic.simulation.organ.TendonRule;

/**
 * What is to be simulated: a body, a way to breathe, a material and how to compute it. Read from YAML; every key has a
 * default, so that an empty scenario is a quiet breath of the virtual adult male. Two scenarios are equal if they
 * resolve to the same {@link #toMap}.
 *
 * @param givenName name, null for that of the preset
 * @param preset breathing preset
 * @param trace recorded breathing whose curve replaces that of the preset
 * @param material what the springs stand for
 * @param anatomy {@code virtual/adult-male}, {@code virtual/adult-female} or the path of a thorax folder
 * @param resolution how finely to mesh
 * @param givenDurationS simulated time, s; NaN for as long as the breathing pattern takes, two breaths or a whole hold
 *     or recording
 * @param givenTimeStepS step, s; NaN for that of the material
 * @param givenIntegrator scheme; empty for that of the material
 * @param stepPolicy what to do with a step beyond the stability limit
 * @param givenProjectionSweeps sweeps over all constraints a step; 0 for those of the material
 * @param givenRefreshS time after which anchors and wall planes are taken anew, s; NaN for that of material and step
 * @param massScalingS step, s, that velocity Verlet bears after the lightest nodes were made heavier; only in the
 *     physical material
 * @param threads threads to compute on; results do not depend on it
 * @param recordEveryS time between samples of the observables, s
 * @param meshesEveryS time between meshes that are written, s; 0 for none
 * @param muscle whether the diaphragm's muscle is driven
 * @param pressure whether transdiaphragmatic pressure acts
 * @param ribs whether the ribs turn
 * @param tensegrity whether rigid links hold the two faces of the sheet apart
 * @param contact whether the diaphragm slides on the chest wall
 * @param sternum what moves the sternum
 * @param lungs what moves the lungs
 * @param liver whether the liver moves along
 * @param linksPerNode rigid links a node of the sheet, 1 to 3
 * @param tendon which part of the sheet is tendon
 * @param given tunable numbers that the scenario states
 * @param hold whether the breath is held where it is
 * @param givenSteps steps to run instead of the duration; -1 where none are given
 * @param changes made while it runs, in order
 */
public record Scenario(
        String givenName,
        String preset,
        Optional<Path> trace,
        TissueMaterial material,
        String anatomy,
        Resolution resolution,
        double givenDurationS,
        double givenTimeStepS,
        Optional<IntegratorKind> givenIntegrator,
        StepPolicy stepPolicy,
        int givenProjectionSweeps,
        double givenRefreshS,
        double massScalingS,
        int threads,
        double recordEveryS,
        double meshesEveryS,
        boolean muscle,
        boolean pressure,
        boolean ribs,
        boolean tensegrity,
        boolean contact,
        SternumModel sternum,
        LungModel lungs,
        boolean liver,
        int linksPerNode,
        TendonRule tendon,
        Map<Parameter, Double> given,
        boolean hold,
        long givenSteps,
        List<ScheduledChange> changes) {

    /** Bodies that come with the program. */
    public static final List<String> VIRTUAL_BODIES = List.of("virtual/adult-male", "virtual/adult-female");

    /** Greatest number of threads that may be asked for, wherever it is asked. */
    public static final int MAX_THREADS = 256;

    private static final int MAX_DEFAULT_THREADS = 2;
    private static final double RECORD_EVERY_S = 0.02;
    private static final double MASS_SCALING_S = 0.00125;
    /**
     * Contact and the order of the faces share nodes: what is left of their quarrel after three sweeps is below a
     * thousandth of an excursion.
     */
    private static final int PHYSICAL_SWEEPS = 3;

    private static final double REFRESH_S = 0.02;
    private static final double REFRESH_STEPS = 4;
    /** After 0.08 s the wall is 10 % of a breath's excursion from where it should be. */
    private static final double MAX_REFRESH_S = 0.04;

    public Scenario {
        Map<Parameter, Double> copy = new EnumMap<>(Parameter.class);
        copy.putAll(given);
        given = Collections.unmodifiableMap(copy);
        changes = List.copyOf(changes);
    }

    /** A quiet breath of the virtual adult male. */
    public static Scenario defaults() {
        return new Scenario(
                null,
                "quiet",
                Optional.empty(),
                TissueMaterial.PHYSICAL,
                VIRTUAL_BODIES.get(0),
                Resolution.MEDIUM,
                Double.NaN,
                Double.NaN,
                Optional.empty(),
                StepPolicy.SUBSTEP,
                0,
                Double.NaN,
                MASS_SCALING_S,
                Math.min(MAX_DEFAULT_THREADS, Runtime.getRuntime().availableProcessors()),
                RECORD_EVERY_S,
                0,
                true,
                true,
                true,
                true,
                true,
                SternumModel.SPRINGS,
                LungModel.SPRINGS,
                true,
                1,
                TendonRule.TREFOIL,
                Map.of(),
                false,
                -1,
                List.of());
    }

    /** The keys of a scenario file: those of this class, then those of {@link Parameter}. */
    public static List<String> keys() {
        return ScenarioReader.KEYS;
    }

    /**
     * Reads a scenario. Paths in it are taken from its folder.
     *
     * @throws BadInputException with one sentence that names file, line and key
     */
    public static Scenario read(Path file) {
        YamlMap yaml = YamlDocument.read(file);
        if (yaml.keys().isEmpty()) {
            throw new BadInputException(file + ": found no keys, expected 'key: value' lines such as 'preset: quiet'");
        }
        Path folder = file.toAbsolutePath().getParent();
        String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        return ScenarioReader.read(defaults(), yaml, folder, stem);
    }

    /**
     * This scenario with other values of some keys; of two values for a key the later counts. Paths are taken from the
     * working folder.
     *
     * @throws BadInputException with one sentence that names where the value was given and the key
     */
    public Scenario with(List<Assignment> assignments) {
        try {
            YamlMap changes = YamlDocument.parse("", "");
            for (Assignment assignment : assignments) {
                changes = changes.overlaidWith(assignment.toYaml());
            }
            return ScenarioReader.read(this, changes, Path.of(""), givenName);
        } catch (BadInputException e) {
            // A value that comes from no file stands in no line.
            throw new BadInputException(e.getMessage().replaceFirst(": line 1, key", ": key"), e);
        }
    }

    /** This scenario with other values, each as {@code key=value}. */
    public Scenario with(String... assignments) {
        return with(Arrays.stream(assignments).map(Assignment::parse).toList());
    }

    /**
     * This scenario with other changes while it runs.
     *
     * @throws BadInputException with one sentence, if one cannot be made or they are not in order
     */
    public Scenario withChanges(List<ScheduledChange> others) {
        return with(givenSteps, others).requireValidChanges();
    }

    /** This scenario for so many steps. */
    public Scenario withSteps(long steps) {
        return with(steps, changes);
    }

    private Scenario with(long steps, List<ScheduledChange> others) {
        return new Scenario(
                givenName,
                preset,
                trace,
                material,
                anatomy,
                resolution,
                givenDurationS,
                givenTimeStepS,
                givenIntegrator,
                stepPolicy,
                givenProjectionSweeps,
                givenRefreshS,
                massScalingS,
                threads,
                recordEveryS,
                meshesEveryS,
                muscle,
                pressure,
                ribs,
                tensegrity,
                contact,
                sternum,
                lungs,
                liver,
                linksPerNode,
                tendon,
                given,
                hold,
                steps,
                others);
    }

    /** Makes sure that every change can be made after those before it. */
    Scenario requireValidChanges() {
        Scenario now = changes.isEmpty() ? this : with(givenSteps, List.of());
        long before = 0;
        for (ScheduledChange change : changes) {
            if (change.step() < before) {
                throw new BadInputException(change.assignment().origin() + ": found step " + change.step()
                        + " after step " + before + ", expected changes in the order of their steps");
            }
            before = change.step();
            LiveKeys.requireLive(change.assignment());
            now = now.with(List.of(change.assignment()));
        }
        return this;
    }

    /** The settings after all changes, without them. */
    public Scenario afterChanges() {
        return with(givenSteps, List.of())
                .with(changes.stream().map(ScheduledChange::assignment).toList());
    }

    /** What to call it. */
    public String name() {
        return givenName == null ? preset : givenName;
    }

    /** Time step, s: that of the file or of the material. */
    public double timeStepS() {
        if (!Double.isNaN(givenTimeStepS)) {
            return givenTimeStepS;
        }
        return material == TissueMaterial.PHYSICAL ? MASS_SCALING_S : 0.01;
    }

    /** Sweeps over all constraints a step: those of the file or of the material. */
    public int projectionSweeps() {
        if (givenProjectionSweeps > 0) {
            return givenProjectionSweeps;
        }
        return material == TissueMaterial.PHYSICAL ? PHYSICAL_SWEEPS : 1;
    }

    /** Scheme: that of the file, else that of the material. */
    public IntegratorKind integrator() {
        return givenIntegrator.orElse(material.integrator());
    }

    /**
     * Time after which anchors and wall planes are taken anew, s: that of the file, else 0.02 s and at least four
     * steps, but no more than 0.04 s.
     */
    public double refreshS() {
        return Double.isNaN(givenRefreshS)
                ? Math.min(MAX_REFRESH_S, Math.max(REFRESH_S, REFRESH_STEPS * timeStepS()))
                : givenRefreshS;
    }

    /** Simulated time, s; NaN where none is given. */
    public double durationS() {
        return givenDurationS;
    }

    /**
     * Simulated time, s: that of the file or as long as it takes to see all of the breathing
     * ({@link BreathingPattern#fullDurationS}).
     */
    public double durationS(BreathingPattern pattern) {
        return Double.isNaN(givenDurationS) ? pattern.fullDurationS() : givenDurationS;
    }

    /** Whether the body comes with the program; else {@link #anatomy} is a folder. */
    public boolean isVirtual() {
        return VIRTUAL_BODIES.contains(anatomy);
    }

    /**
     * Value of a parameter: that of the file or the material's default; NaN where the breathing preset gives it or the
     * material does not use it.
     */
    public double value(Parameter parameter) {
        return given.getOrDefault(parameter, parameter.defaultFor(material));
    }

    /** Whether the scenario states the parameter. */
    public boolean states(Parameter parameter) {
        return given.containsKey(parameter);
    }

    /** The breathing preset as it comes with the program, before this scenario's rate, depth and the rest. */
    public BreathingPreset breathing() {
        try {
            return BreathingPreset.named(preset);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Every key with its value, in the order of the documentation: reading it back gives an equal scenario. Keys whose
     * value the preset gives are left out.
     */
    public Map<String, Object> toMap() {
        return ScenarioWriter.map(this);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Scenario scenario && toMap().equals(scenario.toMap());
    }

    @Override
    public int hashCode() {
        return toMap().hashCode();
    }
}
