package org.phrenic.parameter;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.document.KeySuggestion;

/**
 * The numbers that can be tuned: the one table from which scenario files, {@code --set}, validation, sliders and
 * {@code docs/parameters.md} are made. A parameter that a material does not use has no default there and is refused in
 * its scenarios.
 */
public enum Parameter {
    MUSCLE_STIFFNESS(
            "muscle_stiffness_n_per_m",
            "Muscle stiffness",
            "N/m",
            30,
            3000,
            300,
            Double.NaN,
            "Membrane stiffness E h of the whole sheet in muscle."),
    TENDON_RATIO(
            "tendon_stiffness_ratio",
            "Tendon to muscle",
            "1",
            1,
            50,
            10,
            1,
            "Stiffness of the central tendon as a multiple of the muscle's; 5 to 10 make it all but inextensible in a breath."),
    SPRING_STIFFNESS(
            "spring_stiffness_n_per_m",
            "Spring stiffness",
            "N/m",
            1,
            500,
            Double.NaN,
            15,
            "One stiffness k for every spring (Villard, Bourne and Bello 2009)."),
    NODE_MASS(
            "node_mass_kg",
            "Node mass",
            "kg",
            0.001,
            10,
            Double.NaN,
            0.1,
            "One mass for every node (Villard, Bourne and Bello 2009)."),
    AREA_DENSITY(
            "area_density_kg_per_m2",
            "Mass per area",
            "kg/m^2",
            3,
            1000,
            60,
            Double.NaN,
            "Mass per area of a face; scaled up from the 3.15 of muscle alone, for a breath is quasi-static and the abdomen's contents move along."),
    DAMPING(
            "damping_ns_per_m",
            "Damping",
            "N s/m",
            0,
            100,
            Double.NaN,
            0.02,
            "Viscous damping of a node (Villard, Bourne and Bello 2009, eq. 4)."),
    DAMPING_RATE(
            "damping_rate_per_s", "Damping over mass", "1/s", 0, 200, 10, Double.NaN, "Viscous damping over mass."),
    MUSCLE_ACTIVATION(
            "muscle_activation",
            "Muscle activation",
            "1",
            0,
            0.8,
            0.68,
            Double.NaN,
            "Shortening of the muscle's rest length at full drive, as a share of it."),
    LEFT_OVER_RIGHT(
            "left_over_right",
            "Left over right",
            "1",
            0.2,
            5,
            1.12,
            Double.NaN,
            "Activation of the left hemidiaphragm over that of the right; deep breaths move the left dome 1.07 times as far"
                    + " in men, 1.12 in women (Boussuges 2009). The stronger side takes muscle_activation."),
    FRONT_OVER_BACK(
            "front_over_back",
            "Front over back",
            "1",
            0.2,
            5,
            1,
            Double.NaN,
            "Activation of the diaphragm's front over that of its back, changing smoothly over 50 mm to each side of its middle. The stronger takes what left_over_right leaves it."),
    MUSCLE_FORCE(
            "muscle_force_mn",
            "Muscle force",
            "mN",
            0,
            1000,
            Double.NaN,
            300,
            "Force on a node on an action line at full drive (Villard, Bourne and Bello 2009)."),
    ACTION_RADIUS(
            "action_line_radius_mm",
            "Action line radius",
            "mm",
            5,
            200,
            Double.NaN,
            60,
            "Distance from an action line at which its force has fallen to nothing."),
    REST_PRESSURE(
            "rest_pressure_kpa",
            "Pressure at rest",
            "kPa",
            0,
            2,
            0.25,
            Double.NaN,
            "Transdiaphragmatic pressure at end-expiration; about 3 cmH2O (0.3 kPa) in man."),
    GREATEST_PRESSURE(
            "greatest_pressure_kpa",
            "Pressure of effort",
            "kPa",
            0,
            20,
            1.8,
            Double.NaN,
            "Transdiaphragmatic pressure added at the greatest effort, scaled to the model's soft muscle."),
    PRESSURE_LEFT_OVER_RIGHT(
            "pressure_left_over_right",
            "Pressure left over right",
            "1",
            0.2,
            5,
            1,
            Double.NaN,
            "Pressure of effort under the left hemidiaphragm over that under the right; the greater is what the effort makes."),
    RIB_ROTATION("rib_rotation", "Rib rotation", "1", 0, 1.5, 1, 1, "Multiplies the turn of every rib."),
    UPPER_RIB_ROTATION(
            "upper_rib_rotation",
            "Upper ribs",
            "1",
            0,
            2,
            1,
            1,
            "Multiplies besides the turn of ribs 1 to 3, of rib 4 by two thirds of that, of rib 5 by one third."),
    LOWER_RIB_ROTATION(
            "lower_rib_rotation",
            "Lower ribs",
            "1",
            0,
            2,
            1,
            1,
            "Multiplies besides the turn of ribs 9 to 12, of rib 8 by two thirds of that, of rib 7 by one third."),
    RIB_LEFT_OVER_RIGHT(
            "rib_left_over_right",
            "Ribs left over right",
            "1",
            0.2,
            5,
            1,
            1,
            "Turn of the left ribs over that of the right; the side that turns farther takes rib_rotation."),
    BUCKET_HANDLE(
            "bucket_handle",
            "Bucket handle",
            "1",
            0,
            3,
            1,
            1,
            "Multiplies what each rib turns to raise its side (about the antero-posterior axis), and leaves what raises its front; bones are taken to differ in this by 10 degrees of axis and more."),
    STERNUM_COUPLING(
            "sternum_coupling",
            "Sternum coupling",
            "1",
            0,
            10,
            1,
            1,
            "Multiplies the springs that hold sternum and costal cartilages to the ribs."),
    LUNG_STIFFNESS(
            "lung_stiffness_n_per_m",
            "Lung stiffness",
            "N/m",
            0.1,
            100,
            5,
            Double.NaN,
            "Membrane stiffness of the lungs' surface."),
    MEDIASTINUM_RIGHT(
            "mediastinum_right_mm",
            "Mediastinum right",
            "mm",
            0,
            40,
            0,
            Double.NaN,
            "How far the mediastinal surface of the right lung is pushed out at full inspiration, where heart and mediastinum, which the model lacks, become narrower and longer."),
    MEDIASTINUM_LEFT(
            "mediastinum_left_mm", "Mediastinum left", "mm", 0, 40, 0, Double.NaN, "The same of the left lung."),
    RATE("rate_per_min", "Rate", "1/min", 2, 150, "Breaths a minute."),
    DEPTH("depth", "Depth", "1", 0, 2, 1, 1, "Multiplies all drives of the breathing preset, each at most to full."),
    INSPIRATORY_FRACTION("inspiratory_fraction", "Inspiratory fraction", "1", 0.1, 0.8, "Ti / Ttot."),
    CHEST_SHARE(
            "chest_share",
            "Chest share",
            "1",
            0,
            1,
            "Balance of chest and abdomen: 0 breathes with the diaphragm alone, 1 with the ribs alone, 0.5 leaves both as they stand.");

    private final String key;
    private final String label;
    private final String unit;
    private final double minimum;
    private final double maximum;
    private final double physicalDefault;
    private final double paperDefault;
    private final boolean givenByPreset;
    private final String description;

    Parameter(
            String key,
            String label,
            String unit,
            double minimum,
            double maximum,
            double physicalDefault,
            double paperDefault,
            String meaning) {
        this.key = key;
        this.label = label;
        this.unit = unit;
        this.minimum = minimum;
        this.maximum = maximum;
        this.physicalDefault = physicalDefault;
        this.paperDefault = paperDefault;
        this.givenByPreset = false;
        this.description = meaning;
    }

    /** A parameter whose default the breathing preset gives. */
    Parameter(String key, String label, String unit, double minimum, double maximum, String meaning) {
        this.key = key;
        this.label = label;
        this.unit = unit;
        this.minimum = minimum;
        this.maximum = maximum;
        this.physicalDefault = Double.NaN;
        this.paperDefault = Double.NaN;
        this.givenByPreset = true;
        this.description = meaning;
    }

    /** Name in scenario files and on the command line, with its unit. */
    public String key() {
        return key;
    }

    /** Name for people. */
    public String label() {
        return label;
    }

    /** Unit; {@code 1} for a plain number. */
    public String unit() {
        return unit;
    }

    public double minimum() {
        return minimum;
    }

    public double maximum() {
        return maximum;
    }

    /** Value where a scenario gives none; NaN if the breathing preset gives it or the material does not use it. */
    public double defaultFor(TissueMaterial material) {
        return material == TissueMaterial.PHYSICAL ? physicalDefault : paperDefault;
    }

    /** Whether the breathing preset gives the default. */
    public boolean isGivenByPreset() {
        return givenByPreset;
    }

    /** Whether scenarios of this material may give it. */
    public boolean isUsedBy(TissueMaterial material) {
        return givenByPreset || !Double.isNaN(defaultFor(material));
    }

    /** What it is and where its default comes from, in one sentence. */
    public String description() {
        return description;
    }

    /** All keys, in the order of the table. */
    public static List<String> keys() {
        return Arrays.stream(values()).map(Parameter::key).toList();
    }

    /**
     * The parameter of this key.
     *
     * @throws IllegalArgumentException if there is none; the sentence has the nearest key
     */
    public static Parameter named(String key) {
        for (Parameter parameter : values()) {
            if (parameter.key.equals(key)) {
                return parameter;
            }
        }
        String hint = KeySuggestion.nearest(key, keys())
                .map(near -> "did you mean '" + near + "'?")
                .orElse("expected one of " + String.join(", ", keys()));
        throw new IllegalArgumentException("found an unknown parameter '" + key + "', " + hint);
    }

    /** What is wrong with {@code value}, as "found 9, expected 0 to 2"; empty if it is within the range. */
    public Optional<String> rangeViolation(double value) {
        return value >= minimum && value <= maximum
                ? Optional.empty()
                : Optional.of("found " + format(value) + ", expected " + range());
    }

    /**
     * Refuses a value that is not a number or out of range.
     *
     * @return the value
     * @throws IllegalArgumentException with one sentence
     */
    public double requireInRange(double value) {
        rangeViolation(value).ifPresent(problem -> {
            throw new IllegalArgumentException(key + ": " + problem);
        });
        return value;
    }

    /** The table as Markdown: what {@code docs/parameters.md} holds. */
    public static String markdown() {
        return Arrays.stream(values())
                .map(p -> String.join(
                        " | ",
                        "| `" + p.key + "`",
                        p.unit,
                        format(p.minimum) + " to " + format(p.maximum),
                        p.cell(TissueMaterial.PHYSICAL),
                        p.cell(TissueMaterial.PAPER),
                        p.description + " |\n"))
                .collect(Collectors.joining(
                        "",
                        """
                        # Parameters

                        The numbers that can be tuned, as keys of a scenario file or with `--set key=value`. "preset": the breathing preset gives it;
                        "-": the material does not use it. This table is made from `org.phrenic.simulation.Parameter`.

                        | key | unit | range | `physical` | `paper` | what it is |
                        |---|---|---|---|---|---|
                        """,
                        ""));
    }

    private String cell(TissueMaterial material) {
        if (givenByPreset) {
            return "preset";
        }
        return isUsedBy(material) ? format(defaultFor(material)) : "-";
    }

    private String range() {
        return format(minimum) + " to " + format(maximum) + (unit.equals("1") ? "" : " " + unit);
    }

    /** A number for people: without a fraction where it has none. */
    public static String format(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? String.format(Locale.ROOT, "%.0f", value)
                : Double.toString(value);
    }
}
