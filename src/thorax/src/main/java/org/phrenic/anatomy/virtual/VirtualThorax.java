package org.phrenic.anatomy.virtual;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ForkJoinTask;
import java.util.function.Supplier;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.MarchingTetrahedra;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.SurfaceRelaxation;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.file.Numbers;
import org.phrenic.file.SoftValues;
import org.phrenic.file.UserCache;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** Generates a thorax at end-expiration from its measures. Equal measures give bitwise equal meshes. */
public final class VirtualThorax {
    private static final double VERTEBRA_GRID_MM = 4.0;
    private static final double RIGHT_LUNG_SHARE = 0.53;
    private static final int VERTEBRA_SWEEPS = 3;
    private static final Tube RIB = new Tube(12, 60, 2.4, 3);
    private static final Tube DISC = new Tube(28, 4, 2.3, 1);
    /** Bodies of presets by name and resolution, kept while memory allows. */
    private static final SoftValues<Thorax> PRESETS = new SoftValues<>();

    /** Meshes of presets that do not depend on the number of vertices, by name, kept while memory allows. */
    private static final SoftValues<Map<String, TriangleMesh>> FIXED = new SoftValues<>();

    private final VirtualThoraxParameters parameters;
    private final MeshBudget budget;
    private final Map<String, TriangleMesh> fixed;
    private final Spine spine;
    private final ChestWallShape wall;
    private final VertebraShape[] vertebrae = new VertebraShape[VirtualThoraxParameters.VERTEBRAE];
    private final SternumShape sternum;
    private final DiaphragmShape dome;

    private VirtualThorax(VirtualThoraxParameters parameters, MeshBudget budget, Map<String, TriangleMesh> fixed) {
        this.parameters = parameters;
        this.budget = budget;
        this.fixed = fixed;
        spine = new Spine(parameters.spine());
        wall = new ChestWallShape(parameters.chestWall(), spine);
        for (int level = 1; level <= vertebrae.length; level++) {
            vertebrae[level - 1] = new VertebraShape(spine, level);
        }
        sternum = new SternumShape(parameters.sternum(), spine);
        dome = new DiaphragmShape(parameters.diaphragm(), wall);
    }

    /**
     * Generates the thorax.
     *
     * @param budget number of vertices of the deformable parts; rigid parts do not depend on it
     * @throws IllegalStateException if the measures contradict each other, such as a dome above the apex of the lung
     */
    public static Thorax generate(VirtualThoraxParameters parameters, MeshBudget budget) {
        return new VirtualThorax(parameters, budget, new ConcurrentHashMap<>()).build();
    }

    /** Generates the thorax at a resolution. */
    public static Thorax generate(VirtualThoraxParameters parameters, Resolution resolution) {
        return generate(parameters, resolution.budget());
    }

    /**
     * The thorax of a preset. It is generated at the first call and kept while memory allows; its meshes are shared.
     *
     * @throws IllegalArgumentException if there is no preset of this name
     */
    public static Thorax ofPreset(String preset, Resolution resolution) {
        return ofPreset(preset, resolution.budget());
    }

    /** The thorax of a preset with a number of vertices. */
    public static Thorax ofPreset(String preset, MeshBudget budget) {
        return ofPreset(preset, budget, UserCache.off());
    }

    /** The thorax of a preset with a number of vertices, read from a cache or kept there. */
    public static Thorax ofPreset(String preset, MeshBudget budget, UserCache cache) {
        String key = key(preset, budget);
        return PRESETS.get(key, () -> CachedBody.in(cache, key, () -> generatePreset(preset, budget))
                .withOrgans(VirtualOrgans.ofPreset(preset, cache)));
    }

    /** Generates the thorax of a preset, with the meshes that its other numbers of vertices have as well. */
    private static Thorax generatePreset(String preset, MeshBudget budget) {
        Map<String, TriangleMesh> fixed = FIXED.get(preset, ConcurrentHashMap::new);
        return new VirtualThorax(VirtualThoraxParameters.preset(preset), budget, fixed).build();
    }

    /** A mesh that does not depend on the number of vertices. */
    private TriangleMesh fixed(String name, Supplier<TriangleMesh> generated) {
        TriangleMesh known = fixed.get(name);
        if (known != null) {
            return known;
        }
        TriangleMesh mesh = generated.get();
        fixed.put(name, mesh);
        return mesh;
    }

    /** The thorax of a preset as a cache holds it; empty if it does not. */
    public static Optional<Thorax> read(UserCache cache, String preset, MeshBudget budget) {
        return CachedBody.read(cache, key(preset, budget))
                .map(body -> body.withOrgans(VirtualOrgans.ofPreset(preset, cache)));
    }

    private static String key(String preset, MeshBudget budget) {
        return preset + " " + budget.vertices();
    }

    /** Generates the parts in parallel and lists them in the order bones, spine, organs. */
    private Thorax build() {
        int right = (int) Math.round(budget.lungVertices() * RIGHT_LUNG_SHARE);
        int left = budget.lungVertices() - right;
        // Fork the longest tasks first: other threads steal the oldest task, this thread runs the newest.
        var diaphragm = fork(() -> structureList(
                "diaphragm",
                StructureKind.DIAPHRAGM,
                Side.MIDLINE,
                new DiaphragmSheet(parameters.diaphragm(), dome, wall).mesh(budget.diaphragmVertices())));
        var lungR = fork(() -> structureList("lung_R", StructureKind.LUNG, Side.RIGHT, lung(Side.RIGHT, right)));
        var lungL = fork(() -> structureList("lung_L", StructureKind.LUNG, Side.LEFT, lung(Side.LEFT, left)));
        var liver = fork(() -> structureList(
                "liver", StructureKind.LIVER, Side.MIDLINE, fixed("liver", () -> new LiverShape(parameters, wall, dome)
                        .mesh())));
        var skin = fork(() ->
                structureList("skin_torso", StructureKind.SKIN, Side.MIDLINE, fixed("skin_torso", () -> new SkinShape(
                                parameters.skin())
                        .mesh())));
        var discs = fork(this::discs);
        List<ForkJoinTask<List<Structure>>> spineParts = new ArrayList<>();
        for (int level = vertebrae.length; level >= 1; level--) {
            int at = level;
            spineParts.add(0, fork(() -> List.of(vertebra(at))));
        }
        List<Structure> structures = new ArrayList<>(bones());
        spineParts.forEach(part -> structures.addAll(part.join()));
        // Join in reverse order of forking, so that this thread runs tasks that have not started.
        for (var part : List.of(discs, skin, liver, lungL, lungR, diaphragm)) {
            part.join();
        }
        List.of(discs, diaphragm, lungR, lungL, liver, skin).forEach(part -> structures.addAll(part.join()));
        return new Thorax(parameters.name(), structures, List.of()).withOrgans(VirtualOrgans.of(parameters));
    }

    private static ForkJoinTask<List<Structure>> fork(Callable<List<Structure>> part) {
        return ForkJoinTask.adapt(part).fork();
    }

    private List<Structure> bones() {
        List<Structure> bones = new ArrayList<>();
        RibCageCourses skeleton = new RibCageCourses(parameters, spine, wall, vertebrae, sternum);
        SternumMeshes meshes = new SternumMeshes(parameters, wall, budget.sternumVertices());
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            Polyline above = null;
            for (int level = 1; level <= 12; level++) {
                Polyline rib = skeleton.ribCourse(level, side);
                bones.add(new Structure(sided("rib", level, side), StructureKind.RIB, level, side, rib(rib)));
                if (level <= 7) {
                    above = skeleton.trueCartilage(level, side, rib);
                } else if (level <= 10) {
                    above = skeleton.falseCartilage(level, side, rib, above);
                }
                if (level <= 10) {
                    meshes.cartilage(level, side, above);
                }
            }
        }
        bones.addAll(meshes.build(sternum));
        return bones;
    }

    private TriangleMesh rib(Polyline course) {
        VirtualThoraxParameters.Ribs ribs = parameters.ribs();
        double whole = course.length();
        return RIB.mesh(
                course,
                t -> {
                    double fromHead = t * whole;
                    double neck = SmoothBlends.smoothstep((fromHead - 12) / 40);
                    double end = SmoothBlends.smoothstep((whole - fromHead) / 40);
                    double height = ribs.heightMm() * (0.72 + 0.28 * neck) * (0.92 + 0.08 * end);
                    double thickness = ribs.thicknessMm() * (1.12 - 0.12 * neck) * (0.9 + 0.1 * end);
                    return new Tube.Section(height / 2, thickness / 2);
                },
                wall::boneBedNormal);
    }

    private Structure vertebra(int level) {
        String name = "vertebra_" + vertebraName(level, "%02d");
        return new Structure(name, StructureKind.VERTEBRA, level, Side.MIDLINE, fixed(name, () -> vertebraMesh(level)));
    }

    private TriangleMesh vertebraMesh(int level) {
        VertebraShape shape = vertebrae[level - 1];
        double[] centre = spine.centre(spine.bodyPath(level));
        double[] low = Vectors.addScaled(centre, Vectors.of(-52, -30, -48), 1);
        double[] high = Vectors.addScaled(centre, Vectors.of(52, 78, 34), 1);
        TriangleMesh rough = MarchingTetrahedra.surface(shape, low, high, VERTEBRA_GRID_MM);
        return SurfaceRelaxation.relax(rough, VERTEBRA_SWEEPS, v -> shape);
    }

    private List<Structure> discs() {
        List<Structure> discs = new ArrayList<>();
        for (int level = 1; level < vertebrae.length; level++) {
            String name = "disc_" + vertebraName(level, "%d") + "_" + vertebraName(level + 1, "%d");
            discs.add(new Structure(name, StructureKind.DISC, level, Side.MIDLINE, disc(level)));
        }
        return discs;
    }

    private TriangleMesh disc(int level) {
        VirtualThoraxParameters.Spine m = parameters.spine();
        double half = m.discHeightMm().at(level - 1) / 2 + RibCageCourses.OVERLAP_MM / 2;
        double path = spine.discPath(level);
        List<double[]> middle = new ArrayList<>();
        for (int i = -2; i <= 2; i++) {
            middle.add(spine.centre(path + half * i / 2));
        }
        double width = (m.bodyWidthMm().at(level - 1) + m.bodyWidthMm().at(level)) / 4;
        double depth = (m.bodyDepthMm().at(level - 1) + m.bodyDepthMm().at(level)) / 4;
        return DISC.mesh(new Polyline(middle), t -> new Tube.Section(width, depth), p -> Vectors.of(0, -1, 0));
    }

    private TriangleMesh lung(Side side, int vertices) {
        return new LungShape(parameters.lungs(), parameters.diaphragm(), wall, dome, side, LungShape.COSTAL_EDGE_MM)
                .mesh(vertices);
    }

    private static List<Structure> structureList(String name, StructureKind kind, Side side, TriangleMesh mesh) {
        return List.of(new Structure(name, kind, 0, side, mesh));
    }

    static String sided(String name, int level, Side side) {
        return Numbers.format("%s_%02d_%s", name, level, side == Side.LEFT ? "L" : "R");
    }

    private static String vertebraName(int level, String digits) {
        return level <= 12 ? Numbers.format("T" + digits, level) : Numbers.format("L" + digits, level - 12);
    }
}
