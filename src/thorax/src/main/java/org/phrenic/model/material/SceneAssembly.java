package org.phrenic.model.material;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ComputedArrays;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.model.assembly.BreathDrive;
import org.phrenic.model.assembly.NodeMasses;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.model.organ.LungModel;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.model.organ.RecessTracks;
import org.phrenic.model.organ.Remeshing;
import org.phrenic.model.organ.SternumModel;
import org.phrenic.model.organ.SternumPart;
import org.phrenic.model.organ.TendonRule;
import org.phrenic.model.organ.ThoracicFace;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.SettingValues;

/**
 * Assembles a scene from settings and a thorax. Only the organs and parts that the settings require are built. Meshing
 * takes most of the time, so independent meshes are built in parallel.
 */
public final class SceneAssembly {
    private final SettingValues settings;
    private final TissueMaterial material;
    private final MeshBudget budget;
    private final Thorax thorax;
    private final Scene scene;

    private SceneAssembly(SettingValues settings, Scene scene) {
        this.settings = settings;
        this.scene = scene;
        thorax = scene.thorax();
        material = settings.get(Materials.MATERIAL);
        budget = OrganSettings.budget(settings);
    }

    /**
     * Assembles a scene.
     *
     * @param values of its parameters during the run
     * @param computed arrays that may be known from an earlier run
     */
    public static Scene assemble(
            SettingValues settings,
            Thorax thorax,
            RampedValues values,
            BreathDrive drive,
            RibCage cage,
            Workers workers,
            ComputedArrays computed) {
        RibCagePose pose = new RibCagePose(cage, new RibRotation.Drive(values, drive));
        return new SceneAssembly(settings, new Scene(settings, thorax, values, drive, pose, workers, computed)).build();
    }

    /**
     * Refuses a body without the parts that breathe.
     *
     * @throws BadInputException with one sentence
     */
    public static void requireBreathing(Thorax thorax) {
        boolean noSheet = thorax.structuresOf(StructureKind.DIAPHRAGM).isEmpty();
        boolean noRibs = thorax.structuresOf(StructureKind.RIB).isEmpty();
        if (noSheet || noRibs) {
            String lack = noSheet && noRibs ? "diaphragm and no ribs" : noSheet ? "diaphragm" : "ribs";
            throw new BadInputException(
                    thorax.name() + ": this body cannot breathe, found no " + lack + ", expected a diaphragm and ribs");
        }
    }

    private Scene build() {
        RibCage cage = scene.pose().cage();
        SternumModel sternumModel = settings.get(OrganSettings.STERNUM);
        LungModel lungModel = settings.get(OrganSettings.LUNGS);
        TissueLaw law = material.tissueLaw(settings);
        CompletableFuture<List<Structure>> lungsMeshed = CompletableFuture.supplyAsync(this::lungStructures);
        CompletableFuture<List<SternumPart.BracedStructure>> sternumMeshed = CompletableFuture.supplyAsync(
                () -> sternumModel == SternumModel.SPRINGS ? SternumPart.mesh(thorax, budget) : List.of());
        CompletableFuture<SkinningWeights> weights =
                CompletableFuture.supplyAsync(() -> SkinningWeights.of(thorax, cage));
        Diaphragm tissue = diaphragm();
        Optional<CompletableFuture<ThoracicFace>> face = lungModel == LungModel.SPRINGS
                ? Optional.of(CompletableFuture.supplyAsync(() -> new ThoracicFace(tissue)))
                : Optional.empty();
        scene.setDiaphragm(material.diaphragm(scene, tissue, law));
        // The liver depends on the diaphragm alone and is needed last.
        Optional<CompletableFuture<LiverPart>> liver = liver();
        Optional<SternumPart> sternum = sternumModel == SternumModel.SPRINGS
                ? Optional.of(new SternumPart(scene.nodes(), join(sternumMeshed), cage, law))
                : Optional.empty();
        List<Structure> lungs = join(lungsMeshed);
        scene.setBones(join(weights));
        scene.setWall(material.chestWall(scene, lungs));
        MovingChestWall wall = scene.wall().orElse(null);
        double stiffness = material.lungToMuscleStiffness(settings);
        scene.setLungs(face.filter(f -> !lungs.isEmpty())
                .map(f -> new LungPart(scene.nodes(), lungs, join(f), scene.bones(), wall, law, stiffness)));
        placeNodes(face, sternum);
        addParts();
        scene.setOrgans(sternum, liver.map(SceneAssembly::join), lungModel == LungModel.EMBEDDED ? lungs : List.of());
        scene.close();
        return scene;
    }

    /** Creates the nodes. */
    private void placeNodes(Optional<CompletableFuture<ThoracicFace>> face, Optional<SternumPart> sternum) {
        double[] positions = scene.nodes().positions();
        // The recess tracks are computed while the particle system is created.
        scene.setRecessTracks(scene.lungs()
                .filter(l -> scene.wall().isPresent())
                .map(l -> MassSpringBuilder.positionsOf(positions, 0, l.baseSprings.node()))
                .map(points -> CompletableFuture.supplyAsync(() -> new RecessTracks(join(face.orElseThrow()), points)))
                .<Supplier<RecessTracks>>map(future -> () -> join(future)));
        NodeLayout layout = sternum.filter(part -> part.nodeCount() > 0 && material.stepsSternumApart())
                .map(part -> NodeLayout.morton(positions, part.firstNodes.get(0), part.nodeCount()))
                .orElseGet(() -> NodeLayout.morton(positions));
        NodeMasses masses = new NodeMasses(scene.nodes().masses(), material.leastMasses(scene, positions));
        ParticleSystem system = new ParticleSystem(layout, positions, masses.all(), scene.workers());
        system.setProjectionSweeps(settings.get(Numerics.PROJECTION_SWEEPS));
        system.add(scene.drive());
        scene.setSystem(system, positions, settings.get(Numerics.REFRESH), masses);
    }

    private void addParts() {
        // Every parameter of the material has a value during the run, even if this scene has no part that uses it.
        material.parameters().forEach(scene::ramped);
        for (ScenePart.Stage stage : ScenePart.Stage.values()) {
            for (ScenePart part : material.parts()) {
                if (part.stage() == stage) {
                    part.addTo(scene);
                }
            }
        }
    }

    /** Waits for a result and rethrows the task's exception. */
    private static <T> T join(CompletableFuture<T> future) {
        try {
            return future.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof Error cause) {
                throw cause;
            }
            throw e.getCause() instanceof RuntimeException cause ? cause : e;
        }
    }

    private Optional<CompletableFuture<LiverPart>> liver() {
        return settings.get(OrganSettings.LIVER)
                ? thorax.structuresOf(StructureKind.LIVER).stream()
                        .findFirst()
                        .map(s -> CompletableFuture.supplyAsync(() -> new LiverPart(s, scene.diaphragm())))
                : Optional.empty();
    }

    private List<Structure> lungStructures() {
        return settings.get(OrganSettings.LUNGS) == LungModel.OFF
                ? List.of()
                : Remeshing.toBudget(thorax.structuresOf(StructureKind.LUNG), budget.lungVertices());
    }

    /** The closed sheet of the diaphragm's shells at the requested resolution. */
    private Diaphragm diaphragm() {
        TriangleMesh given = thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
        TriangleMesh sheet = Diaphragm.sheetAmong(given)
                .orElseThrow(() -> new BadInputException(thorax.name()
                        + ": the diaphragm has no closed shell, expected a double-layered sheet whose two faces meet at"
                        + " its border"));
        int wanted = budget.diaphragmVertices();
        if (!Remeshing.isAdequate(sheet, wanted)) {
            sheet = Remesher.toVertexCount(sheet, wanted);
        }
        MedianFrame frame = MedianFrame.of(thorax);
        if (settings.get(RigidTendon.TENDON) == TendonRule.PLANE) {
            TriangleMesh upright = frame.toFrame(sheet);
            double[] heights = IntStream.range(0, upright.vertexCount())
                    .mapToDouble(upright::z)
                    .sorted()
                    .toArray();
            return Diaphragm.withTendonAbovePlane(
                    sheet, frame, heights[(int) (heights.length * (1 - Diaphragm.TENDON_SHARE))]);
        }
        return Diaphragm.withTrefoilTendon(sheet, frame, scene.computed());
    }
}
