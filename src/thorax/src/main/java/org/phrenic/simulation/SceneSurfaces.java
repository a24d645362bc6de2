package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.LesionPlace;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.anatomy.contact.SheetContact;
import org.phrenic.anatomy.contact.YieldingOrgan;
import org.phrenic.engine.kinematics.HelicalBody;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.LungMeasure;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.OrganMotion;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.SceneObserver;
import org.phrenic.simulation.observe.SceneOverlays;
import org.phrenic.simulation.observe.SkinMotion;
import org.phrenic.simulation.observe.Surface;

/**
 * All surfaces of a simulation and their current positions. A frame is made in two parts: {@link #read} copies the
 * state of the scene on the simulation's thread, and {@link #write} computes the surfaces from it, on any thread, while
 * the simulation goes on. One is called after the other has returned. All other methods are called on the simulation's
 * thread while no frame is written.
 */
public final class SceneSurfaces {
    /** Writes the current vertex positions of a surface. */
    private interface VertexSource {
        double[] positionsAt(double time, double[] now);
    }

    /** Organs and vessels that are fixed to the spine, the neck or the pelvis. */
    private static final Pattern STILL =
            Pattern.compile("spinal_cord|thyroid_gland|o?esophagus|aorta|brachiocephalic_.*"
                    + "|subclavian_.*|common_carotid_.*|iliac_.*|superior_vena_cava|pulmonary_.*");

    private final Simulation simulation;
    private final Scene scene;
    private final SceneObserver observer;
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<VertexSource> places = new ArrayList<>();
    private final List<Integer> bodies = new ArrayList<>();
    private final List<Integer> lungSurfaces = new ArrayList<>();
    /** Copy of the state: node positions in the caller's order, bones, time, step and observables. */
    private final double[] positions;

    private final RibCagePose pose;
    private double time;
    private long step;
    private double[] values;
    private final Object token = new Object();
    private final SheetContact contact;
    private final SceneCarriers carriers;
    private long captures;
    private SkinningWeights bones;

    /** The surfaces of the scene and of the organs that its body brings. */
    public SceneSurfaces(Simulation simulation) {
        this(simulation, List.of());
    }

    /** As {@link #SceneSurfaces(Simulation)}, with the further organs of the body ({@link Thorax#organs()}). */
    public static SceneSurfaces withOrgans(Simulation simulation) {
        return new SceneSurfaces(
                simulation, simulation.scene().thorax().organs().get());
    }

    private SceneSurfaces(Simulation simulation, List<Structure> organs) {
        this.simulation = simulation;
        scene = simulation.scene();
        observer = new SceneObserver(scene);
        positions = new double[scene.restPositions().length];
        scene.pose().update(0);
        pose = scene.pose().copy();
        contact = new SheetContact(scene.diaphragm().diaphragm, scene.diaphragm().firstNode);
        contact.update(scene.restPositions());
        addDiaphragm();
        scene.sternum().ifPresent(part -> {
            for (int i = 0; i < part.structures.size(); i++) {
                addNodes(part.structures.get(i), part.firstNodes.get(i), new boolean[0]);
            }
        });
        LungMeasure lungs = observer.lungs().after(pose);
        Optional<LiverPart> liver = scene.liver().map(LiverPart::copy);
        carriers = new SceneCarriers(scene, pose, liver);
        for (int i = 0; i < lungs.structures().size(); i++) {
            int lung = i;
            yielding(
                    lungs.structures().get(i),
                    true,
                    (time, at) -> lungs.positions(lung, time, scene.restPositions(), at));
            carryOrgans(places.size() - 1);
        }
        liver.filter(LiverPart::isCarried)
                .ifPresent(part -> yielding(part.structure, false, (time, at) -> carriers.liver()));
        addOthers(scene.thorax().structures());
        addOthers(organs);
    }

    /** Lets a lung carry organs of the chest. */
    private void carryOrgans(int surface) {
        VertexSource lung = places.get(surface);
        int carrier = carriers.addLung(surfaces.get(surface).rest().positions());
        places.set(surface, (time, at) -> {
            double[] now = lung.positionsAt(time, at);
            carriers.moveLung(carrier, now);
            return now;
        });
        lungSurfaces.add(surface);
    }

    private void addOthers(List<Structure> structures) {
        for (Structure s : structures) {
            if (surfaces.stream().noneMatch(known -> known.name().equals(s.name()))) {
                addOther(s);
            }
        }
    }

    private void addDiaphragm() {
        DiaphragmPart part = scene.diaphragm();
        TriangleMesh sheet = part.diaphragm.sheet();
        boolean[] tendon = new boolean[sheet.vertexCount()];
        for (int i = 0; i < tendon.length; i++) {
            tendon[i] = part.diaphragm.isTendon(i);
        }
        Structure given =
                scene.thorax().structuresOf(StructureKind.DIAPHRAGM).get(0).withMesh(sheet);
        addNodes(given, part.firstNode, tendon);
    }

    private void addNodes(Structure s, int first, boolean[] tendon) {
        double[] p = new double[s.mesh().positions().length];
        deforming(
                s,
                (time, at) -> {
                    System.arraycopy(at, 3 * first, p, 0, p.length);
                    return p;
                },
                tendon);
    }

    /** Adds a soft organ that yields to the diaphragm. */
    private void yielding(Structure s, boolean above, VertexSource place) {
        YieldingOrgan organ = new YieldingOrgan(contact, s.mesh(), above);
        deforming(s, (time, at) -> organ.dented(place.positionsAt(time, at)));
    }

    private void deforming(Structure s, VertexSource place, boolean... tendon) {
        TriangleMesh rest = s.mesh()
                .withPositions(place.positionsAt(0, scene.restPositions()).clone());
        add(s, rest, Surface.Motion.DEFORMING, tendon, place, RibCage.TRUNK);
    }

    private void addOther(Structure s) {
        switch (s.kind()) {
            case RIB -> addRigid(s, scene.pose().cage().rib(s.level(), s.side()));
            case STERNUM -> addRigid(s, scene.pose().cage().sternum());
            case COSTAL_CARTILAGE, PLEURA -> addBlended(s);
            case SKIN -> deforming(s, new SkinMotion(scene, s, bones(), pose)::at);
            case ORGAN, VESSEL, LESION -> addFollowing(s);
            default -> addRigid(s, RibCage.TRUNK);
        }
    }

    private void addRigid(Structure s, int body) {
        boolean still = body <= RibCage.TRUNK;
        add(s, s.mesh(), still ? Surface.Motion.STILL : Surface.Motion.RIGID, new boolean[0], null, body);
    }

    /** Adds a structure without nodes or rigid motion, which deforms with the bones around it. */
    private void addBlended(Structure s) {
        double[] rest = s.mesh().positions();
        LinearBlendSkinning motion = new LinearBlendSkinning(pose, rest, bones().weightsAt(rest), Workers.of(1));
        double[] p = new double[rest.length];
        double[] v = new double[rest.length];
        deforming(s, (time, at) -> {
            motion.at(time, p, v);
            return p;
        });
    }

    /** Adds an organ or vessel without nodes, which follows what lies about it. */
    private void addFollowing(Structure s) {
        String name = s.name().toLowerCase(Locale.ROOT);
        if (STILL.matcher(name).matches() || LesionPlace.standsStill(name)) {
            addRigid(s, RibCage.TRUNK);
        } else if (name.startsWith("internal_mammary") || LesionPlace.isInBone(name)) {
            addBlended(s);
        } else {
            OrganMotion motion = carriers.bind(name, s.mesh(), bones());
            addOrgan(s, (time, at) -> motion.now());
        }
    }

    /** An organ on one side of the diaphragm yields to it; one that passes through it does not. */
    private void addOrgan(Structure s, VertexSource place) {
        DiaphragmSide side = DiaphragmSide.of(s.kind(), s.name());
        if (side == DiaphragmSide.NEITHER) {
            deforming(s, place);
        } else {
            yielding(s, side == DiaphragmSide.ABOVE, place);
        }
    }

    private SkinningWeights bones() {
        if (bones == null) {
            bones = SkinningWeights.of(scene.thorax(), scene.pose().cage());
        }
        return bones;
    }

    private void add(
            Structure s, TriangleMesh rest, Surface.Motion motion, boolean[] tendon, VertexSource place, int body) {
        surfaces.add(new Surface(s.name(), s.kind(), s.level(), s.side(), rest, motion, tendon));
        places.add(place);
        bodies.add(body);
    }

    /** The surfaces, in a fixed order. */
    public List<Surface> surfaces() {
        return List.copyOf(surfaces);
    }

    /** The overlays that can be drawn over the surfaces. */
    public List<Overlay> overlays() {
        return SceneOverlays.of(scene);
    }

    /** Creates a frame of this scene with the current state. */
    public Frame newFrame() {
        int n = surfaces.size();
        int[] lengths = new int[n];
        boolean[] rigid = new boolean[n];
        for (int i = 0; i < n; i++) {
            Surface s = surfaces.get(i);
            lengths[i] = s.motion() == Surface.Motion.DEFORMING ? s.rest().positions().length : 0;
            rigid[i] = s.motion() == Surface.Motion.RIGID;
        }
        Frame frame = new Frame(token, lengths, rigid, positions.length);
        capture(frame);
        return frame;
    }

    /** Writes the current state into a frame, between two steps. */
    public void capture(Frame frame) {
        read(observe());
        write(frame);
    }

    /** Copies the current state, of which the observables are given, between two steps, for {@link #write}. */
    public void read(double[] observed) {
        copyState();
        step = simulation.stepper().steps();
        values = observed;
    }

    /** Computes the surfaces in the state that was read last. */
    public void write(Frame frame) {
        moveCarriers();
        for (int i = 0; i < surfaces.size(); i++) {
            switch (surfaces.get(i).motion()) {
                case DEFORMING -> toFloat(places.get(i).positionsAt(time, positions), frame.positions(i));
                case RIGID -> toFloat(pose.pose(bodies.get(i)), frame.pose(i));
                case STILL -> {} // the rest mesh is sufficient
            }
        }
        toFloat(positions, frame.nodes());
        frame.setState(++captures, step, time, values);
    }

    /** Copies the current node positions and bone poses. */
    private void copyState() {
        time = simulation.time();
        scene.system().layout().toCaller(scene.system().positions(), positions);
        scene.pose().update(time);
        pose.copyFrom(scene.pose());
    }

    private void moveCarriers() {
        contact.update(positions);
        carriers.update(time, positions);
    }

    /** All surfaces in the current state, in double precision; for files. */
    public List<TriangleMesh> meshes() {
        copyState();
        moveCarriers();
        return IntStream.range(0, surfaces.size()).mapToObj(this::meshAt).toList();
    }

    /** One surface in the current state, in double precision. */
    public TriangleMesh mesh(int surface) {
        copyState();
        moveCarriers();
        lungSurfaces.forEach(lung -> places.get(lung).positionsAt(time, positions));
        return meshAt(surface);
    }

    private TriangleMesh meshAt(int surface) {
        TriangleMesh rest = surfaces.get(surface).rest();
        return switch (surfaces.get(surface).motion()) {
            case DEFORMING ->
                rest.withPositions(
                        places.get(surface).positionsAt(time, positions).clone());
            case RIGID -> {
                double[] p = new double[rest.positions().length];
                HelicalBody.transformPoints(pose.pose(bodies.get(surface)), rest.positions(), 0, p, 0, p.length / 3);
                yield rest.withPositions(p);
            }
            case STILL -> rest;
        };
    }

    /** Pose of a rigid surface ({@link HelicalBody#transformPoints}) at the last call of {@link #meshes}. */
    public double[] pose(int surface) {
        return pose.pose(bodies.get(surface)).clone();
    }

    /** Observables of the current state, in the order of {@link Observation#COLUMNS}. */
    public double[] observe() {
        return observer.observe(simulation.time()).values();
    }

    private static void toFloat(double[] from, float[] to) {
        for (int i = 0; i < to.length; i++) {
            to[i] = (float) from[i];
        }
    }
}
