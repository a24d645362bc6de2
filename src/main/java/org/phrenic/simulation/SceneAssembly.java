package org.phrenic.simulation;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.anatomy.BlendedMotion;
import org.phrenic.anatomy.BoneWeights;
import org.phrenic.anatomy.ChestWall;
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
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.FallOff;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.format.BadInputException;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshRepair;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.Remesher;
import org.phrenic.geometry.TriangleMesh;

/** Puts a scene together from a scenario and a thorax: only what the scenario asks for is built. */
final class SceneAssembly {
    /** Anchors and wall planes are taken anew this often, and not more often than every few steps; in between they go on at their velocity (an error of some hundredths of a millimetre). */
    private static final double REFRESH_S = 0.02;

    private static final double REFRESH_STEPS = 4;

    /** Step of the physical preset that is to need no substeps; the same whatever step is chosen, so that the body does not depend on it. */
    private static final double SCALED_STEP_S = 1e-3;

    private static final double LINK_TOLERANCE = 1e-6;
    private static final int LINK_SWEEPS = 50;
    /** Conjugate-gradient iterations of the prestress: beyond, tensions grow and the residual hardly falls. */
    private static final int PRESTRESS_ITERATIONS = 40;
    /** Nodes nearer than this to the wall lean on it at rest. */
    private static final double LEAN_MM = 1;

    private static final double SHORTEST_REST = 0.3;
    private static final double DOME_RADIUS_MM = 70;
    /** Fall-off of the paper's attachments round the insertion, and their low elasticity as a share of a spring's. */
    private static final double ATTACHMENT_MM = 25;

    private static final double ATTACHMENT_SHARE = 0.1;
    private static final double HOME_SHARE = 0.25;

    private final Scenario scenario;
    private final Thorax thorax;
    private final Workers workers;
    private final SceneParts parts = new SceneParts();
    private final double refresh;

    private SceneAssembly(Scenario scenario, Thorax thorax, Workers workers) {
        this.scenario = scenario;
        this.thorax = thorax;
        this.workers = workers;
        this.refresh = Math.max(REFRESH_S, REFRESH_STEPS * scenario.timeStepS());
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
        Ahead<List<Structure>> sternumMeshed = Ahead.of(() -> scenario.sternum() == SternumModel.SPRINGS
                ? SternumPart.meshed(thorax, scenario.resolution())
                : List.of());
        Ahead<BoneWeights> weights = Ahead.of(() -> BoneWeights.of(thorax, cage));
        DiaphragmPart diaphragm = new DiaphragmPart(
                parts,
                diaphragm(),
                law,
                value(Parameter.TENDON_RATIO),
                physical,
                scenario.tensegrity() ? scenario.linksPerNode() : 0,
                physical ? value(Parameter.LEFT_OVER_RIGHT) : 1);
        Optional<SternumPart> sternum = scenario.sternum() == SternumModel.SPRINGS
                ? Optional.of(new SternumPart(parts, sternumMeshed.get(), cage, law))
                : Optional.empty();
        List<Structure> lungStructures = lungsMeshed.get();
        BoneWeights bones = weights.get();
        double lungShare = physical ? value(Parameter.LUNG_STIFFNESS) / value(Parameter.MUSCLE_STIFFNESS) : 0.1;
        ChestWall wall = physical ? wall(lungStructures, diaphragm, bones, pose) : null;
        Optional<LungPart> lungs = scenario.lungs() == LungModel.SPRINGS && !lungStructures.isEmpty()
                ? Optional.of(new LungPart(parts, lungStructures, diaphragm, bones, wall, law, lungShare))
                : Optional.empty();

        double[] positions = parts.positions();
        NodeLayout layout = NodeLayout.morton(positions);
        double[] masses = parts.masses();
        double massAdded = physical ? scaleMasses(positions, masses) : 0;
        ParticleSystem system = new ParticleSystem(layout, positions, masses, workers);
        if (physical) {
            system.setViscosityPerMass(value(Parameter.DAMPING_RATE));
        } else {
            system.setViscosity(value(Parameter.DAMPING));
        }
        system.add(drive);
        int attachments = hold(system, diaphragm, bones, pose, positions);
        Optional<SlidingContact> contact = Optional.empty();
        double residual = 0;
        if (physical) {
            int[] sliding = diaphragm.sliding(wall);
            double[] slidingRest = points(positions, diaphragm.first, sliding);
            ContactSurface felt = wall.holding(
                    slidingRest,
                    Arrays.stream(sliding).mapToDouble(diaphragm::inset).toArray());
            residual = prestress(system, drive, diaphragm, felt, sliding, slidingRest, positions);
            if (scenario.contact()) {
                contact = Optional.of(new SlidingContact(layout, shifted(sliding, diaphragm.first), felt, refresh));
            }
        }
        addSprings(system, drive, diaphragm, positions);
        Optional<RigidLinks> links = Optional.empty();
        if (scenario.tensegrity() && !diaphragm.links.isEmpty()) {
            links = Optional.of(links(layout, diaphragm, positions));
            system.add(links.get());
        }
        if (physical) {
            system.add(diaphragm.order(layout, refresh));
        }
        contact.ifPresent(system::add);
        if (wall != null && lungs.isPresent()) {
            int[] pleural = lungs.get().pleural();
            system.add(SlidingContact.adhering(layout, pleural, wall.keeping(points(positions, 0, pleural)), refresh));
        }
        Optional<LiverPart> liver = scenario.liver()
                ? thorax.all(StructureKind.LIVER).stream().findFirst().map(s -> new LiverPart(s, diaphragm))
                : Optional.empty();
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
                liver,
                links,
                contact,
                parts.diaphragm.count() + parts.passive.count(),
                attachments,
                residual,
                massAdded);
    }

    /** Makes nodes that alone would shorten the step heavier; returns the mass added, per cent. */
    private double scaleMasses(double[] positions, double[] masses) {
        MassScaling scaling = new MassScaling(positions, masses);
        scaling.springs(parts.diaphragm);
        scaling.springs(parts.passive);
        scaling.attachments(parts.attachedNodes(), parts.attachedStiffnesses(), value(Parameter.STERNUM_COUPLING));
        scaling.scaleFor(SCALED_STEP_S / Stepper.SAFETY);
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
        TriangleMesh sheet = MeshRepair.components(given).stream()
                .filter(m -> new MeshTopology(m).isClosed() && MeshMeasure.signedVolume(m) > 0)
                .max(Comparator.comparingInt(TriangleMesh::vertexCount))
                .orElseThrow(() -> new BadInputException(thorax.name()
                        + ": the diaphragm has no closed shell, expected a double-layered sheet whose two faces meet at"
                        + " its border"));
        int wanted = scenario.resolution().diaphragmVertices();
        if (Math.abs(sheet.vertexCount() - wanted) > 0.01 * wanted) {
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

    private static int[] shifted(int[] vertices, int first) {
        return Arrays.stream(vertices).map(i -> first + i).toArray();
    }

    private static double[] points(double[] positions, int first, int[] vertices) {
        double[] out = new double[3 * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(positions, 3 * (first + vertices[i]), out, 3 * i, 3);
        }
        return out;
    }

    /** The insertion follows bone exactly; sternum, cartilages and lungs by springs to anchors on bone. Returns how many nodes are held. */
    private int hold(
            ParticleSystem system, DiaphragmPart diaphragm, BoneWeights bones, RibCagePose pose, double[] positions) {
        int[] inserted = diaphragm.inserted();
        if (inserted.length == 0) {
            throw new BadInputException(thorax.name() + ": the diaphragm has no border that bone could hold, expected a"
                    + " sheet whose two faces meet at its insertion");
        }
        double[] rim = points(positions, diaphragm.first, inserted);
        system.prescribe(shifted(inserted, diaphragm.first), new BlendedMotion(pose, rim, bones.at(rim), workers));
        if (scenario.material() == Material.PAPER) {
            Diaphragm sheet = diaphragm.diaphragm;
            for (int i = 0; i < sheet.sheet().vertexCount(); i++) {
                double fade = FallOff.at(sheet.distanceFromInsertion(i), ATTACHMENT_MM);
                if (fade > 0 && !sheet.isInserted(i)) {
                    parts.attach(diaphragm.first + i, ATTACHMENT_SHARE * value(Parameter.SPRING_STIFFNESS) * fade);
                }
            }
        }
        int[] attached = parts.attachedNodes();
        if (attached.length > 0) {
            double[] anchors = points(positions, 0, attached);
            Attachments springs = new Attachments(
                    system.layout(),
                    attached,
                    parts.attachedStiffnesses(),
                    0,
                    new BlendedMotion(pose, anchors, bones.at(anchors), workers));
            springs.setRefreshInterval(refresh);
            springs.setFactor(value(Parameter.STERNUM_COUPLING));
            system.add(springs);
        }
        if (scenario.material() == Material.PAPER) {
            system.add(home(system, diaphragm, positions));
        }
        return inserted.length + attached.length;
    }

    /**
     * The paper's sheet has no pressure below it and no bending: nothing would bring it back after a breath. Every node is held to its place by a spring of low elasticity, soft enough that the action lines move the
     * dome, quick enough (6 1/s) to follow a breath.
     */
    private Attachments home(ParticleSystem system, DiaphragmPart diaphragm, double[] positions) {
        int[] free = shifted(diaphragm.free(), diaphragm.first);
        double[] stiffness = new double[free.length];
        Arrays.fill(stiffness, HOME_SHARE * value(Parameter.SPRING_STIFFNESS));
        return new Attachments(system.layout(), free, stiffness, 0, PrescribedMotion.still(points(positions, 0, free)));
    }

    private ChestWall wall(List<Structure> lungs, DiaphragmPart diaphragm, BoneWeights bones, RibCagePose pose) {
        Diaphragm sheet = diaphragm.diaphragm;
        int[] thoracic = IntStream.range(0, sheet.sheet().vertexCount())
                .filter(sheet::isThoracic)
                .toArray();
        double[] contents = DoubleStream.concat(
                        Arrays.stream(points(sheet.sheet().positions(), 0, thoracic)),
                        lungs.stream()
                                .flatMapToDouble(s -> Arrays.stream(s.mesh().positions())))
                .toArray();
        double[] box = sheet.sheet().bounds();
        return new ChestWall(contents, 0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), bones, pose, workers);
    }

    /** Rest lengths that hold the sheet in its given shape against the pressure at rest; what they leave is carried by a dead load. */
    private double prestress(
            ParticleSystem system,
            BreathDrive drive,
            DiaphragmPart diaphragm,
            ContactSurface wall,
            int[] sliding,
            double[] slidingRest,
            double[] positions) {
        NodeLayout layout = system.layout();
        if (!scenario.pressure()) {
            return 0;
        }
        int[] pressed = diaphragm.abdominalTriangles();
        double[] weight = new double[pressed.length / 3];
        Arrays.fill(weight, 1);
        FacePressure pressure = new FacePressure(layout, pressed, weight);
        system.add(pressure);
        drive.drives(pressure, value(Parameter.REST_PRESSURE), value(Parameter.GREATEST_PRESSURE));
        int n = layout.nodeCount();
        double[] internal = new double[3 * n];
        pressure.setPressure(value(Parameter.REST_PRESSURE));
        for (int block = 0; block < layout.blockCount(); block++) {
            pressure.addForces(system.positions(), system.velocities(), internal, block);
        }
        double[] load = new double[3 * n];
        layout.toCaller(internal, load);

        boolean[] free = new boolean[n];
        int vertices = diaphragm.diaphragm.sheet().vertexCount();
        for (int i = 0; i < vertices; i++) {
            free[diaphragm.first + i] = !diaphragm.diaphragm.isInserted(i);
        }
        double[] normals = new double[3 * n];
        if (scenario.contact()) {
            lean(wall, sliding, slidingRest, diaphragm, normals);
        }
        SpringList springs = parts.diaphragm;
        Prestress solver = new Prestress(positions, springs.nodeA(), springs.nodeB(), free, normals);
        double[] tension = new double[springs.count()];
        double spacing = Math.sqrt(MeshMeasure.area(diaphragm.diaphragm.sheet()) / vertices);
        // Laplace's law for a dome shared by two faces, times the width of tissue that an edge stands for.
        Arrays.fill(tension, value(Parameter.REST_PRESSURE) * DOME_RADIUS_MM / 2 / 2 * spacing);
        solver.solve(load, tension, PRESTRESS_ITERATIONS);
        double[] stiffness = springs.stiffness();
        double[] length = springs.rest();
        for (int e = 0; e < tension.length; e++) {
            double rest = Math.max(SHORTEST_REST * length[e], length[e] - tension[e] / stiffness[e]);
            tension[e] = stiffness[e] * (length[e] - rest);
            springs.setRest(e, rest);
        }
        double[] left = solver.unbalanced(load, tension);
        double squares = 0;
        double all = 0;
        for (int i = 0; i < left.length; i++) {
            squares += left[i] * left[i];
            all += free[i / 3] ? load[i] * load[i] : 0;
            left[i] = -left[i];
        }
        system.add(new ConstantLoad(layout, left));
        return all > 0 ? Math.sqrt(squares / all) : 0;
    }

    private static void lean(
            ContactSurface wall, int[] sliding, double[] rest, DiaphragmPart diaphragm, double[] normals) {
        double[] plane = new double[5];
        wall.prepare(0);
        for (int i = 0; i < sliding.length; i++) {
            double x = rest[3 * i];
            double y = rest[3 * i + 1];
            double z = rest[3 * i + 2];
            wall.planeNear(i, x, y, z, plane, 0);
            if (diaphragm.diaphragm.isThoracic(sliding[i])
                    && plane[0] * x + plane[1] * y + plane[2] * z - plane[3] < LEAN_MM) {
                System.arraycopy(plane, 0, normals, 3 * (diaphragm.first + sliding[i]), 3);
            }
        }
    }

    private void addSprings(ParticleSystem system, BreathDrive drive, DiaphragmPart diaphragm, double[] positions) {
        NodeLayout layout = system.layout();
        boolean contractile = scenario.material() == Material.PHYSICAL && scenario.muscle();
        Springs.Builder sheet = Springs.between(layout, parts.diaphragm.nodeA(), parts.diaphragm.nodeB())
                .stiffness(parts.diaphragm.stiffness())
                .rest(parts.diaphragm.rest());
        if (contractile) {
            sheet.contractile(parts.diaphragm.share());
        }
        Springs springs = sheet.build();
        system.add(springs);
        if (contractile) {
            drive.drives(springs, value(Parameter.MUSCLE_ACTIVATION));
        }
        if (parts.passive.count() > 0) {
            system.add(Springs.between(layout, parts.passive.nodeA(), parts.passive.nodeB())
                    .stiffness(parts.passive.stiffness())
                    .rest(parts.passive.rest())
                    .build());
        }
        if (scenario.material() == Material.PAPER && scenario.muscle()) {
            addActionLines(system, drive, diaphragm, positions);
        }
    }

    /** One line through the middle of each hemidiaphragm, as the paper draws them. */
    private void addActionLines(ParticleSystem system, BreathDrive drive, DiaphragmPart diaphragm, double[] positions) {
        double[] box = diaphragm.diaphragm.sheet().bounds();
        int[] nodes = shifted(diaphragm.free(), diaphragm.first);
        ActionLine[] lines = new ActionLine[2];
        for (int side = 0; side < 2; side++) {
            double x = 0.5 * (box[0] + box[3]) + (side == 0 ? -1 : 1) * 0.25 * (box[3] - box[0]);
            double y = 0.5 * (box[1] + box[4]);
            lines[side] = new ActionLine(system.layout(), nodes, positions, x, y, value(Parameter.ACTION_RADIUS));
            system.add(lines[side]);
        }
        drive.drives(lines, value(Parameter.MUSCLE_FORCE));
    }

    private static RigidLinks links(NodeLayout layout, DiaphragmPart diaphragm, double[] positions) {
        int[] a =
                diaphragm.links.stream().mapToInt(p -> diaphragm.first + p.a()).toArray();
        int[] b =
                diaphragm.links.stream().mapToInt(p -> diaphragm.first + p.b()).toArray();
        return RigidLinks.sweeping(layout, a, b, positions, LINK_TOLERANCE, LINK_SWEEPS);
    }
}
