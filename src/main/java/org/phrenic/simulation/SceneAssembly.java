package org.phrenic.simulation;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.anatomy.BoneWeights;
import org.phrenic.anatomy.ChestWall;
import org.phrenic.anatomy.CruralOrigin;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.RibCage;
import org.phrenic.anatomy.RibCagePose;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.Workers;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.SpringKernel;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.format.BadInputException;
import org.phrenic.geometry.MeshComponents;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.Remesher;
import org.phrenic.geometry.SurfaceSamples;
import org.phrenic.geometry.TriangleMesh;

/** Puts a scene together from a scenario and a thorax: only what the scenario asks for is built. */
final class SceneAssembly {
    private static final double LINK_TOLERANCE = 1e-6;
    private static final int LINK_SWEEPS = 50;

    private final Scenario scenario;
    /** What is fastest for the sheet's springs serves the others too. */
    private SpringKernel kernel;

    private final Thorax thorax;
    private final Workers workers;
    private final SceneParts parts = new SceneParts();
    private final double refresh;

    private SceneAssembly(Scenario scenario, Thorax thorax, Workers workers) {
        this.scenario = scenario;
        this.thorax = thorax;
        this.workers = workers;
        this.refresh = scenario.refreshS();
    }

    static Scene assemble(Scenario scenario, Thorax thorax, BreathDrive drive, RibCage cage, Workers workers) {
        return new SceneAssembly(scenario, thorax, workers).build(drive, cage);
    }

    private Scene build(BreathDrive drive, RibCage cage) {
        boolean physical = scenario.material() == Material.PHYSICAL;
        TissueLaw law = physical
                ? TissueLaw.membrane(value(Parameter.MUSCLE_STIFFNESS), value(Parameter.AREA_DENSITY))
                : TissueLaw.uniform(value(Parameter.SPRING_STIFFNESS), value(Parameter.NODE_MASS));
        RibCagePose pose = new RibCagePose(cage, drive);
        // Meshing takes longest and its parts are independent: they are done side by side.
        Ahead<List<Structure>> lungsMeshed = Ahead.of(this::lungStructures);
        Ahead<List<SternumPart.Braced>> sternumMeshed = Ahead.of(() -> scenario.sternum() == SternumModel.SPRINGS
                ? SternumPart.meshed(thorax, scenario.resolution())
                : List.of());
        Ahead<BoneWeights> weights = Ahead.of(() -> BoneWeights.of(thorax, cage));
        Diaphragm tissue = diaphragm();
        Optional<Ahead<ThoracicFace>> face = scenario.lungs() == LungModel.SPRINGS
                ? Optional.of(Ahead.of(() -> new ThoracicFace(tissue)))
                : Optional.empty();
        DiaphragmPart diaphragm = new DiaphragmPart(
                parts,
                tissue,
                physical
                        ? CruralOrigin.of(thorax, tissue)
                        : new double[tissue.sheet().vertexCount()],
                law,
                value(Parameter.TENDON_RATIO),
                physical,
                scenario.linksPerNode(),
                physical ? value(Parameter.LEFT_OVER_RIGHT) : 1,
                physical ? value(Parameter.FRONT_OVER_BACK) : 1);
        // The liver hangs on the diaphragm alone and is wanted last.
        Optional<Ahead<LiverPart>> liver = scenario.liver()
                ? thorax.all(StructureKind.LIVER).stream()
                        .findFirst()
                        .map(s -> Ahead.of(() -> new LiverPart(s, diaphragm)))
                : Optional.empty();
        Optional<SternumPart> sternum = scenario.sternum() == SternumModel.SPRINGS
                ? Optional.of(new SternumPart(parts, sternumMeshed.get(), cage, law))
                : Optional.empty();
        List<Structure> lungStructures = lungsMeshed.get();
        BoneWeights bones = weights.get();
        double lungShare = physical ? value(Parameter.LUNG_STIFFNESS) / value(Parameter.MUSCLE_STIFFNESS) : 0.1;
        ChestWall wall = physical ? wall(lungStructures, diaphragm, bones, pose) : null;
        Optional<LungPart> lungs = face.filter(f -> !lungStructures.isEmpty())
                .map(f -> new LungPart(parts, lungStructures, f.get(), diaphragm.first, bones, wall, law, lungShare));

        double[] positions = parts.positions();
        // The lines down the sheet are drawn while the system of nodes is put together.
        Optional<Ahead<RecessTracks>> tracks = lungs.filter(l -> wall != null)
                .map(l -> SceneParts.points(positions, 0, l.base.node()))
                .map(points ->
                        Ahead.of(() -> new RecessTracks(face.orElseThrow().get(), points)));
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
        Holding holding = new Holding(scenario, thorax, parts, system, diaphragm, bones, pose, positions, refresh);
        Optional<SlidingContact> contact = Optional.empty();
        Optional<RestPressure> rest = Optional.empty();
        if (physical) {
            int[] sliding = diaphragm.sliding(wall);
            double[] slidingRest = SceneParts.points(positions, diaphragm.first, sliding);
            ContactSurface felt = wall.holding(
                    slidingRest,
                    Arrays.stream(sliding).mapToDouble(diaphragm::inset).toArray());
            rest = Optional.of(new RestPressure(
                    scenario,
                    system,
                    drive,
                    diaphragm,
                    parts.diaphragm,
                    scenario.contact() ? felt : null,
                    sliding,
                    slidingRest,
                    positions));
            contact = Optional.of(
                    new SlidingContact(layout, SceneParts.shifted(sliding, diaphragm.first), felt, refresh));
        }
        Springs sheet = sheetSprings(system, drive);
        Optional<Springs> passive = passiveSprings(system);
        ActionLine[] lines = physical ? new ActionLine[0] : actionLines(system, drive, diaphragm, positions);
        Optional<RigidLinks> links = Optional.empty();
        if (!diaphragm.links.isEmpty()) {
            links = Optional.of(links(layout, diaphragm, positions));
            system.add(links.get());
            system.setEnabled(links.get(), scenario.tensegrity());
        }
        if (physical) {
            system.add(diaphragm.order(layout, refresh));
            system.add(contact.get());
            system.setEnabled(contact.get(), scenario.contact());
        }
        Optional<Attachments> base = Optional.empty();
        if (lungs.isPresent()) {
            base = Optional.of(onDiaphragm(system, lungs.get(), diaphragm, wall, positions, tracks));
        }
        if (wall != null && lungs.isPresent()) {
            push(system, lungs.get(), drive);
            int[] pleural = lungs.get().pleural();
            system.add(SlidingContact.adhering(
                    layout, pleural, wall.keeping(SceneParts.points(positions, 0, pleural)), refresh));
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
                liver.map(Ahead::get),
                new SceneForces(sheet, passive, holding.bone, holding.home, base, rest, lines, links, contact),
                parts.diaphragm.count() + parts.passive.count(),
                holding.nodes,
                rest.map(RestPressure::residual).orElse(0.0),
                massAdded);
    }

    /** Makes nodes that alone would shorten the step heavier; returns the mass added, per cent. */
    private double scaleMasses(double[] positions, double[] masses, DiaphragmPart diaphragm, Optional<LungPart> lungs) {
        MassScaling scaling = new MassScaling(positions, masses);
        scaling.springs(parts.diaphragm);
        scaling.springs(parts.passive);
        scaling.attachments(parts.attachedNodes(), parts.attachedStiffnesses(), value(Parameter.STERNUM_COUPLING));
        scaling.attachments(diaphragm.cruralNodes, diaphragm.cruralStiffnesses, 1);
        lungs.ifPresent(l -> scaling.attachments(l.base.node(), l.base.stiffnesses(), 1));
        scaling.scaleFor(scenario.massScalingS() / Stepper.SAFETY);
        return scaling.addedPercent();
    }

    private List<Structure> lungStructures() {
        return scenario.lungs() == LungModel.OFF
                ? List.of()
                : Remeshing.toBudget(
                        thorax.all(StructureKind.LUNG), scenario.resolution().lungVertices());
    }

    private double value(Parameter parameter) {
        return scenario.value(parameter);
    }

    /** The closed sheet among the diaphragm's shells, at the resolution asked for. */
    private Diaphragm diaphragm() {
        TriangleMesh given = thorax.all(StructureKind.DIAPHRAGM).get(0).mesh();
        TriangleMesh sheet = MeshComponents.of(given).stream()
                .filter(m -> MeshTopology.isClosed(m) && MeshMeasure.signedVolume(m) > 0)
                .max(Comparator.comparingInt(TriangleMesh::vertexCount))
                .orElseThrow(() -> new BadInputException(thorax.name()
                        + ": the diaphragm has no closed shell, expected a double-layered sheet whose two faces meet at"
                        + " its border"));
        int wanted = scenario.resolution().diaphragmVertices();
        if (!Remeshing.isFit(sheet, wanted)) {
            sheet = Remesher.toVertexCount(sheet, wanted);
        }
        if (scenario.tendon() == TendonRule.PLANE) {
            double[] heights = IntStream.range(0, sheet.vertexCount())
                    .mapToDouble(sheet::z)
                    .sorted()
                    .toArray();
            return Diaphragm.abovePlane(sheet, heights[(int) (heights.length * (1 - Diaphragm.TENDON_SHARE))]);
        }
        return Diaphragm.trefoil(sheet);
    }

    private ChestWall wall(List<Structure> lungs, DiaphragmPart diaphragm, BoneWeights bones, RibCagePose pose) {
        Diaphragm sheet = diaphragm.diaphragm;
        SurfaceSamples contents = new SurfaceSamples(ChestWall.MOST_SPACING_MM);
        for (int t = 0; t < sheet.sheet().triangleCount(); t++) {
            if (sheet.isThoracicTriangle(t)) {
                contents.add(sheet.sheet(), t);
            }
        }
        lungs.forEach(s -> contents.add(s.mesh()));
        double[] box = sheet.sheet().bounds();
        return new ChestWall(contents.points(), 0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), bones, pose, workers);
    }

    private Springs sheetSprings(ParticleSystem system, BreathDrive drive) {
        Springs.Builder builder = Springs.between(system.layout(), parts.diaphragm.nodeA(), parts.diaphragm.nodeB())
                .stiffness(parts.diaphragm.stiffness())
                .rest(parts.diaphragm.rest());
        boolean contractile = scenario.material() == Material.PHYSICAL;
        if (contractile) {
            builder.contractile(parts.diaphragm.share());
        }
        Springs springs = builder.build();
        kernel = springs.useFastestKernel(system.positions(), system.velocities());
        system.add(springs);
        if (contractile) {
            drive.drives(springs);
        }
        return springs;
    }

    private Optional<Springs> passiveSprings(ParticleSystem system) {
        if (parts.passive.count() == 0) {
            return Optional.empty();
        }
        Springs springs = Springs.between(system.layout(), parts.passive.nodeA(), parts.passive.nodeB())
                .stiffness(parts.passive.stiffness())
                .rest(parts.passive.rest())
                .build();
        springs.setKernel(kernel);
        system.add(springs);
        return Optional.of(springs);
    }

    /** Lets the drive push the mediastinal surfaces out; the loads are those of tethers that are neither stiffer nor multiplied. */
    private void push(ParticleSystem system, LungPart lungs, BreathDrive drive) {
        ConstantLoad[] loads = new ConstantLoad[2];
        for (int side = 0; side < loads.length; side++) {
            double[] load = lungs.outward(side == 1, system.layout().nodeCount());
            for (int i = 0; i < load.length; i++) {
                load[i] /= value(Parameter.LUNG_STIFFNESS);
            }
            loads[side] = new ConstantLoad(system.layout(), load);
            system.add(loads[side]);
        }
        drive.drives(loads);
    }

    /** The lungs' base, held to the diaphragm as it slides there; without a chest wall as it was at rest. */
    private Attachments onDiaphragm(
            ParticleSystem system,
            LungPart lungs,
            DiaphragmPart diaphragm,
            ChestWall wall,
            double[] positions,
            Optional<Ahead<RecessTracks>> tracks) {
        int[] nodes = lungs.base.node();
        double[] points = SceneParts.points(positions, 0, nodes);
        PrescribedMotion places = tracks.isEmpty()
                ? new CarriedPoints(system, lungs.base.nearestNode(), points)
                : new LungBase(system, diaphragm, wall, points, tracks.get().get());
        Attachments base = new Attachments(system.layout(), nodes, lungs.base.stiffnesses(), 0, places);
        base.setRefreshInterval(refresh);
        system.add(base);
        return base;
    }

    /** One line through the middle of each hemidiaphragm, as the paper draws them. */
    private ActionLine[] actionLines(
            ParticleSystem system, BreathDrive drive, DiaphragmPart diaphragm, double[] positions) {
        int[] nodes = SceneParts.shifted(diaphragm.free(), diaphragm.first);
        ActionLine[] lines = new ActionLine[2];
        for (int side = 0; side < 2; side++) {
            double[] place = diaphragm.linePlace(side == 0 ? -1 : 1);
            lines[side] = new ActionLine(
                    system.layout(), nodes, positions, place[0], place[1], value(Parameter.ACTION_RADIUS));
            system.add(lines[side]);
        }
        drive.drives(lines);
        return lines;
    }

    private static RigidLinks links(NodeLayout layout, DiaphragmPart diaphragm, double[] positions) {
        int[] a =
                diaphragm.links.stream().mapToInt(p -> diaphragm.first + p.a()).toArray();
        int[] b =
                diaphragm.links.stream().mapToInt(p -> diaphragm.first + p.b()).toArray();
        return RigidLinks.sweeping(layout, a, b, positions, LINK_TOLERANCE, LINK_SWEEPS);
    }
}
