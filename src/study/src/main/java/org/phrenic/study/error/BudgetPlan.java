package org.phrenic.study.error;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.Hashes;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;

/**
 * Scenes and meshes of an error budget.
 *
 * @param bodies bodies, the first of which is also measured with every integrator
 * @param breaths breathing presets
 * @param meshes meshes on which the defaults are measured
 * @param sheetVertices numbers of vertices of the diaphragm of the space part, coarsest first
 * @param windowShare part of a breath that is simulated; beyond the end of inspiration for the full excursion
 * @param settings assignments of all scenes
 * @param variants scenarios, on bodies, breaths and meshes of the plan, whose distance from equilibrium is measured
 *     beside that of the defaults
 */
public record BudgetPlan(
        List<Body> bodies,
        List<String> breaths,
        List<Mesh> meshes,
        List<Integer> sheetVertices,
        double windowShare,
        List<String> settings,
        List<Scenario> variants) {
    /** The key with which the text of a plan begins. */
    static final String FIRST_KEY = "program";

    /** Part of a breath until the domes stand lowest: inspiration, a pause, and what they lag behind. */
    private static final double INSPIRATION_SHARE = 0.6;

    /**
     * The diaphragm's vertices at medium resolution, and meshes with edges up to 1.5 times as long and 1.5² times as
     * short. Each has edges √1.5 times as long as the next, so there are enough to tell convergence from scatter.
     */
    private static final List<Integer> SHEET_VERTICES = List.of(3870, 5803, 8705, 13_058, 19_586, 29_379, 44_068);

    /** A body and its name in reports. */
    public record Body(String name, String anatomy) {}

    /** A mesh and its name in reports. */
    public record Mesh(String name, List<String> settings) {}

    public BudgetPlan {
        bodies = List.copyOf(bodies);
        breaths = List.copyOf(breaths);
        meshes = List.copyOf(meshes);
        sheetVertices = List.copyOf(sheetVertices);
        settings = List.copyOf(settings);
        variants = List.copyOf(variants);
    }

    /** The defaults at all resolutions, quiet and deep. */
    public static BudgetPlan full(List<Body> bodies, List<Resolution> resolutions, List<Scenario> variants) {
        return new BudgetPlan(
                bodies,
                List.of("quiet", "deep"),
                resolutions.stream()
                        .map(ReportNumbers::label)
                        .map(name -> new Mesh(name, List.of("resolution=" + name)))
                        .toList(),
                SHEET_VERTICES,
                INSPIRATION_SHARE,
                List.of("threads=1"),
                variants);
    }

    /** The sheet alone on coarse meshes and the start of a quiet breath: seconds. */
    public static BudgetPlan quick(List<Body> bodies) {
        return new BudgetPlan(
                bodies.subList(0, 1),
                List.of("quiet"),
                List.of(mesh(840)),
                List.of(560, 840, 1260),
                0.025,
                List.of("threads=1", "lungs=embedded", "sternum=kinematic", "liver=false"),
                List.of());
    }

    private static Mesh mesh(int sheetVertices) {
        return new Mesh(
                Integer.toString(sheetVertices),
                List.of("mesh_vertices=" + MeshBudget.ofDiaphragm(sheetVertices).vertices()));
    }

    /** Scene of a body and a breath with default settings on a mesh. */
    Scenario scenario(Body body, String breath, Mesh mesh) {
        return scenario(Scenario.defaults(), body, breath, mesh);
    }

    /** The same scene with the settings of another scenario than the default. */
    Scenario scenario(Scenario base, Body body, String breath, Mesh mesh) {
        return base.with("anatomy=" + body.anatomy(), "preset=" + breath)
                .with(settings.toArray(String[]::new))
                .with(mesh.settings().toArray(String[]::new));
    }

    /**
     * Scene of a body and a breath on a mesh of the space part. The time step, and with it the masses that are scaled
     * for it, is proportional to the edge length h on meshes coarser than the default, and to h² on finer ones, so that
     * neither adds to the error of a finer mesh: springs along the sheet ask a node for a mass in proportion to step²,
     * bending for one in proportion to (step / h)², and its area goes by h².
     */
    Scenario refined(Body body, String breath, int sheetVertices) {
        Scenario scenario = scenario(body, breath, mesh(sheetVertices));
        double relativeEdge = Math.sqrt((double) Resolution.MEDIUM.diaphragmVertices() / sheetVertices);
        double relativeStep = Math.min(relativeEdge, relativeEdge * relativeEdge);
        double samples = Math.ceil(BreathRunner.SAMPLE_S / (scenario.timeStepS() * relativeStep));
        double step = BreathRunner.SAMPLE_S / samples;
        double scaled = step / scenario.timeStepS() * scenario.get(Numerics.MASS_SCALING);
        return scenario.with(
                "lungs=embedded",
                "sternum=kinematic",
                "liver=false",
                "time_step_s=" + step,
                "mass_scaling_s=" + scaled);
    }

    /**
     * All that decides what is measured, as text: program version, bodies with their content, breaths, meshes, window,
     * and every setting.
     */
    String identity() {
        Map<String, Object> map = new LinkedHashMap<>();
        String version = BudgetPlan.class.getPackage().getImplementationVersion();
        map.put(FIRST_KEY, version == null ? "not packaged" : version);
        map.put("window_share", windowShare);
        map.put("bodies", bodies.stream().map(BudgetPlan::contentOf).toList());
        map.put("breaths", breaths);
        map.put(
                "meshes",
                meshes.stream().map(m -> m.name() + ": " + m.settings()).toList());
        map.put("sheet_vertices", sheetVertices);
        map.put("settings", settings);
        map.put("defaults", Scenario.defaults().with(Numerics.THREADS, 1).toMap());
        map.put(
                "variants",
                variants.stream()
                        .map(variant -> variant.with(Numerics.THREADS, 1).toMap())
                        .toList());
        return YamlWriter.format(map);
    }

    /** A virtual body by its name, which the program decides, and a folder by its surfaces, wherever it is. */
    private static String contentOf(Body body) {
        if (RunSettings.VIRTUAL_BODIES.contains(body.anatomy())) {
            return body.name() + ": " + body.anatomy();
        }
        StringBuilder text = new StringBuilder();
        for (Structure structure : ThoraxFolder.load(Path.of(body.anatomy())).structures()) {
            text.append(structure.name())
                    .append(Hashes.sha256(structure.mesh().positions()))
                    .append(Hashes.sha256(structure.mesh().triangles()));
        }
        return body.name() + ": " + Hashes.sha256(text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** Whether a measurement is of a scene of this plan. */
    boolean includes(BudgetRow row) {
        boolean scene =
                bodies.stream().anyMatch(body -> body.name().equals(row.body())) && breaths.contains(row.breath());
        boolean mesh = row.part() == BudgetPart.SPACE
                ? sheetVertices.stream().anyMatch(n -> row.mesh().equals(Integer.toString(n)))
                : meshes.stream()
                        .anyMatch(m -> row.mesh().equals(m.name()) || row.mesh().startsWith(m.name() + ", "));
        return scene && mesh;
    }

    /** Simulated time, s. */
    double untilS(Scenario scenario) {
        return windowShare * ErrorStudy.breathS(scenario);
    }
}
