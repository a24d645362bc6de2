package org.phrenic.scenario;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.phrenic.anatomy.Resolution;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.simulation.organ.LungModel;
import org.phrenic.simulation.organ.SternumModel;
import org.phrenic.simulation.organ.TendonRule;

/**
 * What a scenario states besides the numbers of {@link Parameter}: the choices among names, the switches and the
 * settings of the computation. One entry a key, from which the window makes its rows and against which the
 * documentation is held.
 */
public enum Choice {
    PRESET("preset", "Breathing", BreathingPreset.names(), "Way to breathe, from data/breathing."),
    MATERIAL(
            "material",
            "Material",
            labels(TissueMaterial.values(), TissueMaterial::label),
            "physical: a membrane with pressure and muscle that shortens. paper: the springs of Villard, Bourne and Bello 2009."),
    ANATOMY("anatomy", "Body", Scenario.VIRTUAL_BODIES, "A virtual body, or a folder of meshes."),
    RESOLUTION(
            "resolution",
            "Resolution",
            labels(Resolution.values(), ScenarioReader::label),
            "How finely to mesh: 12,047, 16,023 or 20,909 vertices, the sizes of Villard, Bourne and Bello 2009, table 1."),
    TIME_STEP(
            "time_step_s",
            "Time step",
            "s",
            1e-5,
            ScenarioReader.MAX_STEP_S,
            "Step of the clock; one beyond the stability limit is split into substeps."),
    INTEGRATOR(
            "integrator",
            "Integrator",
            labels(IntegratorKind.values(), IntegratorKind::label),
            "Scheme that carries positions and velocities over a step."),
    PROJECTION_SWEEPS(
            "projection_sweeps",
            "Projection sweeps",
            "1",
            1,
            ScenarioReader.MAX_SWEEPS,
            "How many times a step goes through links, faces in order and contact, each of which breaks a little of what the others put right."),
    REFRESH(
            "refresh_s",
            "Refresh",
            "s",
            1e-5,
            ScenarioReader.MAX_REFRESH_S,
            "Anchors on bone and the planes of the chest wall are taken anew after so much simulated time; in between they go on at their velocity."),
    MASS_SCALING(
            "mass_scaling_s",
            "Mass scaling",
            "s",
            1e-6,
            ScenarioReader.MAX_SCALED_STEP_S,
            "Physical material: the lightest nodes are made heavier until velocity Verlet bears this step; the less, the less mass is added."),
    THREADS(
            "threads",
            "Threads",
            "1",
            1,
            Scenario.MAX_THREADS,
            "Threads to compute on; the numbers do not depend on it."),
    MUSCLE("muscle", "Muscle", switches(), "The diaphragm's muscle is driven."),
    PRESSURE("pressure", "Pressure", switches(), "Transdiaphragmatic pressure acts."),
    RIBS("ribs", "Ribs", switches(), "The ribs turn about their helical axes."),
    TENSEGRITY("tensegrity", "Tensegrity", switches(), "Rigid links hold the two faces of the sheet apart."),
    CONTACT("contact", "Contact", switches(), "The diaphragm slides on the chest wall and does not pass through it."),
    STERNUM(
            "sternum",
            "Sternum",
            labels(SternumModel.values(), SternumModel::label),
            "springs: held to the ribs by springs. kinematic: a rigid fit to the ribs' ends. off: stands still."),
    LUNGS(
            "lungs",
            "Lungs",
            labels(LungModel.values(), LungModel::label),
            "springs: a membrane held to diaphragm and chest wall. embedded: follow what is near. off: none."),
    LIVER("liver", "Liver", switches(), "The liver moves along with the dome."),
    LINKS_PER_NODE("links_per_node", "Links per node", List.of("1", "2", "3"), "Rigid links a node of the sheet."),
    TENDON(
            "tendon",
            "Tendon",
            labels(TendonRule.values(), TendonRule::label),
            "Central tendon: trefoil, or all above a plane as in Villard, Bourne and Bello 2009.");

    private final String key;
    private final String label;
    // Made by List.of, Stream.toList or List.copyOf alone.
    @SuppressWarnings("ImmutableEnumChecker")
    private final List<String> options;

    private final String unit;
    private final double minimum;
    private final double maximum;
    private final String description;

    Choice(String key, String label, List<String> options, String meaning) {
        this.key = key;
        this.label = label;
        this.options = options;
        this.unit = "1";
        this.minimum = Double.NaN;
        this.maximum = Double.NaN;
        this.description = meaning;
    }

    Choice(String key, String label, String unit, double minimum, double maximum, String meaning) {
        this.key = key;
        this.label = label;
        this.options = List.of();
        this.unit = unit;
        this.minimum = minimum;
        this.maximum = maximum;
        this.description = meaning;
    }

    private static <E> List<String> labels(E[] constants, Function<E, String> label) {
        return Arrays.stream(constants).map(label).toList();
    }

    private static List<String> switches() {
        return List.of("true", "false");
    }

    /** Name in scenario files and on the command line. */
    public String key() {
        return key;
    }

    /** Name for people. */
    public String label() {
        return label;
    }

    /** Values to choose from, as a scenario has them; empty for a number. A body may also be a folder. */
    public List<String> options() {
        return options;
    }

    /** Whether it is a number between {@link #minimum} and {@link #maximum}. */
    public boolean isNumber() {
        return options.isEmpty();
    }

    /** Whether it is either true or false. */
    public boolean isSwitch() {
        return options.equals(switches());
    }

    /** Unit of a number; {@code 1} for a plain one. */
    public String unit() {
        return unit;
    }

    /** Least number that is offered; NaN for what is no number. */
    public double minimum() {
        return minimum;
    }

    /** Greatest number; NaN for what is no number. */
    public double maximum() {
        return maximum;
    }

    /** What it is, in a sentence or two. */
    public String description() {
        return description;
    }

    /** Its value in a scenario, as a scenario file has it. */
    public String valueIn(Scenario scenario) {
        return String.valueOf(scenario.toMap().get(key));
    }
}
