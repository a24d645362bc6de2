package org.phrenic.simulation.assembly;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.anatomy.CruralOrigin;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.SpringKernel;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.mesh.query.SurfaceSamples;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.organ.DiaphragmPart;
import org.phrenic.simulation.organ.LiverPart;
import org.phrenic.simulation.organ.LungBaseMotion;
import org.phrenic.simulation.organ.LungModel;
import org.phrenic.simulation.organ.LungPart;
import org.phrenic.simulation.organ.MassSpringBuilder;
import org.phrenic.simulation.organ.NodeFollowers;
import org.phrenic.simulation.organ.RecessTracks;
import org.phrenic.simulation.organ.Remeshing;
import org.phrenic.simulation.organ.SternumModel;
import org.phrenic.simulation.organ.SternumPart;
import org.phrenic.simulation.organ.TendonRule;
import org.phrenic.simulation.organ.ThoracicFace;
import org.phrenic.simulation.organ.TissueLaw;

/** Puts a scene together from a scenario and a thorax: only what the scenario asks for is built. */
public final class SceneAssembly {
    private static final double LINK_TOLERANCE = 1e-6;
    private static final int LINK_SWEEPS = 50;

    private final Scenario scenario;
    /** What is fastest for the sheet's springs serves the others too. */
    private SpringKernel kernel;

    private final Thorax thorax;
    private final Workers workers;
    private final MassSpringBuilder parts = new MassSpringBuilder();
    private final double refresh;

    private SceneAssembly(Scenario scenario, Thorax thorax, Workers workers) {
        this.scenario = scenario;
        this.thorax = thorax;
        this.workers = workers;
        this.refresh = scenario.refreshS();
    }

    public static Scene assemble(Scenario scenario, Thorax thorax, BreathDrive drive, RibCage cage, Workers workers) {
        return new SceneAssembly(scenario, thorax, workers).build(drive, cage);
    }

    private Scene build(BreathDrive drive, RibCage cage) {
        boolean physical = scenario.material() == TissueMaterial.PHYSICAL;
        TissueLaw law = physical
                ? TissueLaw.membrane(value(Parameter.MUSCLE_STIFFNESS), value(Parameter.AREA_DENSITY))
                : TissueLaw.uniform(value(Parameter.SPRING_STIFFNESS), value(Parameter.NODE_MASS));
        RibCagePose pose = new RibCagePose(cage, drive);
        // Meshing takes longest and its parts are independent: they are done side by side.
        AsyncResult<List<Structure>> lungsMeshed = AsyncResult.start(this::lungStructures);
        AsyncResult<List<SternumPart.BracedStructure>> sternumMeshed =
                AsyncResult.start(() -> scenario.sternum() == SternumModel.SPRINGS
                        ? SternumPart.mesh(thorax, scenario.resolution())
                        : List.of());
        AsyncResult<SkinningWeights> weights = AsyncResult.start(() -> SkinningWeights.of(thorax, cage));
        Diaphragm tissue = diaphragm();
        Optional<AsyncResult<ThoracicFace>> face = scenario.lungs() == LungModel.SPRINGS
                ? Optional.of(AsyncResult.start(() -> new ThoracicFace(tissue)))
                : Optional.empty();
        DiaphragmPart diaphragm = new DiaphragmPart(
                parts,
                tissue,
                physical
                        ? CruralOrigin.attachmentShares(thorax, tissue)
                        : new double[tissue.sheet().vertexCount()],
                law,
                value(Parameter.TENDON_RATIO),
                physical,
                scenario.linksPerNode(),
                physical ? value(Parameter.LEFT_OVER_RIGHT) : 1,
                physical ? value(Parameter.FRONT_OVER_BACK) : 1);
        // The liver hangs on the diaphragm alone and is wanted last.
        Optional<AsyncResult<LiverPart>> liver = scenario.liver()
                ? thorax.structuresOf(StructureKind.LIVER).stream()
                        .findFirst()
                        .map(s -> AsyncResult.start(() -> new LiverPart(s, diaphragm)))
                : Optional.empty();
        Optional<SternumPart> sternum = scenario.sternum() == SternumModel.SPRINGS
                ? Optional.of(new SternumPart(parts, sternumMeshed.get(), cage, law))
                : Optional.empty();
        List<Structure> lungStructures = lungsMeshed.get();
        SkinningWeights bones = weights.get();
        double lungShare = physical ? value(Parameter.LUNG_STIFFNESS) / value(Parameter.MUSCLE_STIFFNESS) : 0.1;
        MovingChestWall wall = physical ? chestWall(lungStructures, diaphragm, bones, pose) : null;
        Optional<LungPart> lungs = face.filter(f -> !lungStructures.isEmpty())
                .map(f ->
                        new LungPart(parts, lungStructures, f.get(), diaphragm.firstNode, bones, wall, law, lungShare));

        double[] positions = parts.positions();
        // The lines down the sheet are drawn while the system of nodes is put together.
        Optional<AsyncResult<RecessTracks>> tracks = lungs.filter(l -> wall != null)
                .map(l -> MassSpringBuilder.positionsOf(positions, 0, l.baseSprings.node()))
                .map(points -> AsyncResult.start(
                        () -> new RecessTracks(face.orElseThrow().get(), points)));
        NodeLayout layout = NodeLayout.morton(positions);
        double[] masses = parts.masses();
        double massAdded = physical ? scaleMasses(positions, masses, diaphragm, lungs) : 0;
        ParticleSystem system = new ParticleSystem(layout, positions, masses, workers);
        if (physical) {
            system.setViscosityPerMass(value(Parameter.DAMPING_RATE));
        } else {
            system.setViscosity(value(Parameter.DAMPING));
        }
        system.setProjectionSweeps(scenario.projectionSweeps());
        system.add(drive);
        BoundaryAttachments holding =
                new BoundaryAttachments(scenario, thorax, parts, system, diaphragm, bones, pose, positions, refresh);
        Optional<SlidingContact> contact = Optional.empty();
        Optional<RestPressure> rest = Optional.empty();
        if (physical) {
            int[] sliding = diaphragm.slidingVertices(wall);
            double[] slidingRest = MassSpringBuilder.positionsOf(positions, diaphragm.firstNode, sliding);
            ContactSurface felt = wall.limitingContact(
                    slidingRest,
                    Arrays.stream(sliding).mapToDouble(diaphragm::wallInset).toArray());
            rest = Optional.of(new RestPressure(
                    scenario,
                    system,
                    drive,
                    diaphragm,
                    parts.sheetSprings,
                    scenario.contact() ? felt : null,
                    sliding,
                    slidingRest,
                    positions));
            contact = Optional.of(
                    new SlidingContact(layout, MassSpringBuilder.offset(sliding, diaphragm.firstNode), felt, refresh));
        }
        Springs sheet = sheetSprings(system, drive);
        Optional<Springs> passive = passiveSprings(system);
        ActionLine[] lines = physical ? new ActionLine[0] : actionLines(system, drive, diaphragm, positions);
        Optional<RigidLinks> links = Optional.empty();
        if (!diaphragm.links.isEmpty()) {
            links = Optional.of(rigidLinks(layout, diaphragm, positions));
            system.add(links.get());
            system.setEnabled(links.get(), scenario.tensegrity());
        }
        if (physical) {
            system.add(diaphragm.orderedPairs(layout, refresh));
            system.add(contact.get());
            system.setEnabled(contact.get(), scenario.contact());
        }
        Optional<Attachments> base = Optional.empty();
        if (lungs.isPresent()) {
            base = Optional.of(attachLungBase(system, lungs.get(), diaphragm, wall, positions, tracks));
        }
        if (wall != null && lungs.isPresent()) {
            addMediastinalLoads(system, lungs.get(), drive);
            int[] pleural = lungs.get().pleuralNodes();
            system.add(SlidingContact.adhering(
                    layout,
                    pleural,
                    wall.slidingContact(MassSpringBuilder.positionsOf(positions, 0, pleural)),
                    refresh));
        }
        return new Scene(
                thorax,
                system,
                positions,
                pose,
                drive,
                diaphragm,
                sternum,
                lungs,
                scenario.lungs() == LungModel.EMBEDDED ? lungStructures : List.of(),
                liver.map(AsyncResult::get),
                new SceneForces(
                        sheet, passive, holding.bone, holding.restoringSprings, base, rest, lines, links, contact),
                parts.sheetSprings.count() + parts.passiveSprings.count(),
                holding.heldNodes,
                rest.map(RestPressure::residual).orElse(0.0),
                massAdded);
    }

    /** Makes nodes that alone would shorten the step heavier; returns the mass added, per cent. */
    private double scaleMasses(double[] positions, double[] masses, DiaphragmPart diaphragm, Optional<LungPart> lungs) {
        MassScaling scaling = new MassScaling(positions, masses);
        scaling.addSprings(parts.sheetSprings);
        scaling.addSprings(parts.passiveSprings);
        scaling.addAttachments(parts.attachedNodes(), parts.attachedStiffnesses(), value(Parameter.STERNUM_COUPLING));
        scaling.addAttachments(diaphragm.cruralNodes, diaphragm.cruralStiffnesses, 1);
        lungs.ifPresent(l -> scaling.addAttachments(l.baseSprings.node(), l.baseSprings.stiffnesses(), 1));
        scaling.raiseMassesFor(scenario.massScalingS() / Stepper.SAFETY);
        return scaling.addedPercent();
    }

    private List<Structure> lungStructures() {
        return scenario.lungs() == LungModel.OFF
                ? List.of()
                : Remeshing.toBudget(
                        thorax.structuresOf(StructureKind.LUNG),
                        scenario.resolution().lungVertices());
    }

    private double value(Parameter parameter) {
        return scenario.value(parameter);
    }

    /** The closed sheet among the diaphragm's shells, at the resolution asked for. */
    private Diaphragm diaphragm() {
        TriangleMesh given = thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
        TriangleMesh sheet = ConnectedComponents.of(given).stream()
                .filter(m -> new EdgeTable(m).isClosed() && MeshMeasure.signedVolume(m) > 0)
                .max(Comparator.comparingInt(TriangleMesh::vertexCount))
                .orElseThrow(() -> new BadInputException(thorax.name()
                        + ": the diaphragm has no closed shell, expected a double-layered sheet whose two faces meet at"
                        + " its border"));
        int wanted = scenario.resolution().diaphragmVertices();
        if (!Remeshing.isAdequate(sheet, wanted)) {
            sheet = Remesher.toVertexCount(sheet, wanted);
        }
        if (scenario.tendon() == TendonRule.PLANE) {
            double[] heights = IntStream.range(0, sheet.vertexCount())
                    .mapToDouble(sheet::z)
                    .sorted()
                    .toArray();
            return Diaphragm.withTendonAbovePlane(
                    sheet, heights[(int) (heights.length * (1 - Diaphragm.TENDON_SHARE))]);
        }
        return Diaphragm.withTrefoilTendon(sheet);
    }

    private MovingChestWall chestWall(
            List<Structure> lungs, DiaphragmPart diaphragm, SkinningWeights bones, RibCagePose pose) {
        Diaphragm sheet = diaphragm.diaphragm;
        SurfaceSamples contents = new SurfaceSamples(MovingChestWall.MAX_SPACING_MM);
        for (int t = 0; t < sheet.sheet().triangleCount(); t++) {
            if (sheet.isThoracicTriangle(t)) {
                contents.add(sheet.sheet(), t);
            }
        }
        lungs.forEach(s -> contents.add(s.mesh()));
        double[] box = sheet.sheet().bounds();
        return new MovingChestWall(
                contents.points(), 0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), bones, pose, workers);
    }

    private Springs sheetSprings(ParticleSystem system, BreathDrive drive) {
        Springs.Builder builder = Springs.between(
                        system.layout(), parts.sheetSprings.nodeA(), parts.sheetSprings.nodeB())
                .stiffness(parts.sheetSprings.stiffness())
                .restLengths(parts.sheetSprings.rest());
        boolean contractile = scenario.material() == TissueMaterial.PHYSICAL;
        if (contractile) {
            builder.contractileShares(parts.sheetSprings.contractileShare());
        }
        Springs springs = builder.build();
        kernel = springs.useFastestKernel(system.positions(), system.velocities());
        system.add(springs);
        if (contractile) {
            drive.attach(springs);
        }
        return springs;
    }

    private Optional<Springs> passiveSprings(ParticleSystem system) {
        if (parts.passiveSprings.count() == 0) {
            return Optional.empty();
        }
        Springs springs = Springs.between(system.layout(), parts.passiveSprings.nodeA(), parts.passiveSprings.nodeB())
                .stiffness(parts.passiveSprings.stiffness())
                .restLengths(parts.passiveSprings.rest())
                .build();
        springs.setKernel(kernel);
        system.add(springs);
        return Optional.of(springs);
    }

    /**
     * Lets the drive push the mediastinal surfaces out; the loads are those of tethers that are neither stiffer nor
     * multiplied.
     */
    private void addMediastinalLoads(ParticleSystem system, LungPart lungs, BreathDrive drive) {
        ConstantLoad[] loads = new ConstantLoad[2];
        for (int side = 0; side < loads.length; side++) {
            double[] load = lungs.outwardLoad(side == 1, system.layout().nodeCount());
            for (int i = 0; i < load.length; i++) {
                load[i] /= value(Parameter.LUNG_STIFFNESS);
            }
            loads[side] = new ConstantLoad(system.layout(), load);
            system.add(loads[side]);
        }
        drive.attach(loads);
    }

    /** The lungs' base, held to the diaphragm as it slides there; without a chest wall as it was at rest. */
    private Attachments attachLungBase(
            ParticleSystem system,
            LungPart lungs,
            DiaphragmPart diaphragm,
            MovingChestWall wall,
            double[] positions,
            Optional<AsyncResult<RecessTracks>> tracks) {
        int[] nodes = lungs.baseSprings.node();
        double[] points = MassSpringBuilder.positionsOf(positions, 0, nodes);
        PrescribedMotion places = tracks.isEmpty()
                ? new NodeFollowers(system, lungs.baseSprings.nearestNode(), points)
                : new LungBaseMotion(
                        system, diaphragm, wall, points, tracks.get().get());
        Attachments base = new Attachments(system.layout(), nodes, lungs.baseSprings.stiffnesses(), 0, places);
        base.setRefreshInterval(refresh);
        system.add(base);
        return base;
    }

    /** One line through the middle of each hemidiaphragm, as the paper draws them. */
    private ActionLine[] actionLines(
            ParticleSystem system, BreathDrive drive, DiaphragmPart diaphragm, double[] positions) {
        int[] nodes = MassSpringBuilder.offset(diaphragm.freeVertices(), diaphragm.firstNode);
        ActionLine[] lines = new ActionLine[2];
        for (int side = 0; side < 2; side++) {
            double[] place = diaphragm.actionLinePosition(side == 0 ? -1 : 1);
            lines[side] = new ActionLine(
                    system.layout(), nodes, positions, place[0], place[1], value(Parameter.ACTION_RADIUS));
            system.add(lines[side]);
        }
        drive.attach(lines);
        return lines;
    }

    private static RigidLinks rigidLinks(NodeLayout layout, DiaphragmPart diaphragm, double[] positions) {
        int[] a = diaphragm.links.stream()
                .mapToInt(p -> diaphragm.firstNode + p.a())
                .toArray();
        int[] b = diaphragm.links.stream()
                .mapToInt(p -> diaphragm.firstNode + p.b())
                .toArray();
        return RigidLinks.gaussSeidel(layout, a, b, positions, LINK_TOLERANCE, LINK_SWEEPS);
    }
}
