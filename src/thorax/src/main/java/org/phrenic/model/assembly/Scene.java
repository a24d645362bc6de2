package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.ComputedArrays;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.RecessTracks;
import org.phrenic.model.organ.SternumPart;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.SettingValues;
import org.phrenic.parameter.SwitchSetting;

/**
 * A thorax assembled for a run: the nodes, the forces and constraints on them, and the nodes of each organ. The
 * assembly creates the nodes; then the parts of the material add forces and constraints.
 */
public final class Scene {
    private final SettingValues settings;
    private final Thorax thorax;
    private final RampedValues values;
    private final BreathDrive drive;
    private final RibCagePose pose;
    private final Workers workers;
    private final ComputedArrays computed;
    private MassSpringBuilder nodes = new MassSpringBuilder();
    private int springCount;
    private final SceneTuning tuning;
    private final List<double[]> actionLines = new ArrayList<>();
    private DiaphragmPart diaphragm;
    private Optional<LungPart> lungs = Optional.empty();
    private SkinningWeights bones;
    private Optional<MovingChestWall> wall = Optional.empty();
    private Optional<Supplier<RecessTracks>> tracks = Optional.empty();
    private double[] positions;
    private double refreshS;
    private ParticleSystem system;
    private SlidingSheet slidingSheet;
    private RestPressure restPressure;
    private Springs sheet;
    private Springs passive;
    private RigidLinks links;
    private Attachments lungBase;
    private int[] heldNodes = {};
    private Optional<SternumPart> sternum = Optional.empty();
    private Optional<LiverPart> liver = Optional.empty();
    private List<Structure> embeddedLungs = List.of();
    private NodeMasses nodeMasses;

    public Scene(
            SettingValues settings,
            Thorax thorax,
            RampedValues values,
            BreathDrive drive,
            RibCagePose pose,
            Workers workers,
            ComputedArrays computed) {
        this.settings = settings;
        this.thorax = thorax;
        this.values = values;
        this.drive = drive;
        this.pose = pose;
        this.workers = workers;
        this.computed = computed;
        tuning = new SceneTuning(values);
    }

    public SettingValues settings() {
        return settings;
    }

    public Thorax thorax() {
        return thorax;
    }

    /** Arrays of this scene that may be known from an earlier run. */
    public ComputedArrays computed() {
        return computed;
    }

    public RibCagePose pose() {
        return pose;
    }

    public BreathDrive drive() {
        return drive;
    }

    public Workers workers() {
        return workers;
    }

    /** Collects nodes, springs and attachments during assembly. */
    public MassSpringBuilder nodes() {
        return nodes;
    }

    public DiaphragmPart diaphragm() {
        return diaphragm;
    }

    public void setDiaphragm(DiaphragmPart part) {
        diaphragm = part;
    }

    public Optional<LungPart> lungs() {
        return lungs;
    }

    public void setLungs(Optional<LungPart> part) {
        lungs = part;
    }

    /** Sets the organs that are added last. */
    public void setOrgans(
            Optional<SternumPart> sternumPart, Optional<LiverPart> liverPart, List<Structure> carriedLungs) {
        sternum = sternumPart;
        liver = liverPart;
        embeddedLungs = carriedLungs;
    }

    public Optional<LiverPart> liver() {
        return liver;
    }

    /** Sternum and cartilages, if they are a mass-spring system. */
    public Optional<SternumPart> sternum() {
        return sternum;
    }

    /** Lungs that follow diaphragm and chest wall without nodes of their own. */
    public List<Structure> embeddedLungs() {
        return embeddedLungs;
    }

    public SkinningWeights bones() {
        return bones;
    }

    public void setBones(SkinningWeights weights) {
        bones = weights;
    }

    /** The wall on which diaphragm and lungs slide; empty if attachments alone hold them. */
    public Optional<MovingChestWall> wall() {
        return wall;
    }

    public void setWall(Optional<MovingChestWall> chestWall) {
        wall = chestWall;
    }

    /** Tracks of the lung border; empty without lungs or wall. */
    public Optional<RecessTracks> recessTracks() {
        return tracks.map(Supplier::get);
    }

    public void setRecessTracks(Optional<Supplier<RecessTracks>> supplier) {
        tracks = supplier;
    }

    /** Number of the first lung node; greater than all node numbers if the lungs have no nodes. */
    public int firstLungNode() {
        return lungs.map(l -> l.firstNodes.get(0)).orElse(Integer.MAX_VALUE);
    }

    /** Sets the particle system. Forces can be added afterwards. */
    public void setSystem(
            ParticleSystem particles, double[] positionsAtRest, double refreshIntervalS, NodeMasses masses) {
        nodeMasses = masses;
        system = particles;
        positions = positionsAtRest;
        refreshS = refreshIntervalS;
    }

    public ParticleSystem system() {
        return system;
    }

    public NodeLayout layout() {
        return system.layout();
    }

    /** Positions of all nodes at end-expiration, caller's order, mm; updated when the scene has settled. */
    public double[] restPositions() {
        return positions;
    }

    /** Interval after which anchors and wall planes are updated, s. */
    public double refreshS() {
        return refreshS;
    }

    /** The vertices of the sheet in contact with the wall, computed once. Requires a wall. */
    public SlidingSheet slidingSheet() {
        if (slidingSheet == null) {
            slidingSheet = SlidingSheet.of(diaphragm, wall.orElseThrow(), positions);
        }
        return slidingSheet;
    }

    public RestPressure restPressure() {
        return restPressure;
    }

    /** Share of the load at rest that the sheet's tensions do not carry. */
    public double prestressResidual() {
        return restPressure == null ? 0 : restPressure.residual();
    }

    public void balancePressure(RestPressure balance) {
        restPressure = balance;
    }

    /** Adds the springs of the diaphragm. */
    public void addSheet(Springs springs) {
        sheet = springs;
        system.add(springs);
    }

    /** The springs of the diaphragm. */
    public Springs sheetSprings() {
        return sheet;
    }

    /** Adds all other springs between nodes. */
    public void addPassive(Springs springs) {
        passive = springs;
        system.add(springs);
    }

    /** All springs between nodes that are not part of the diaphragm. */
    public Optional<Springs> passiveSprings() {
        return Optional.ofNullable(passive);
    }

    /** Adds the rigid links of the tendon. */
    public void addLinks(RigidLinks tendon) {
        links = tendon;
        system.add(tendon);
    }

    /** The tendon's rigid links, whether switched on or off. */
    public Optional<RigidLinks> links() {
        return Optional.ofNullable(links);
    }

    /** The tendon's rigid links if they are switched on. */
    public Optional<RigidLinks> activeLinks() {
        return links().filter(system::isEnabled);
    }

    /** Adds the attachments of the base of the lungs. */
    public void addLungBase(Attachments springs) {
        lungBase = springs;
        system.add(springs);
    }

    /** Attachments of the base of the lungs to the diaphragm, if the lungs are a mass-spring system. */
    public Optional<Attachments> lungBase() {
        return Optional.ofNullable(lungBase);
    }

    /** Marks nodes as attached to bone, rigidly or by springs. */
    public void holdNodes(int[] held) {
        heldNodes = held;
    }

    public int[] heldNodes() {
        return heldNodes;
    }

    /** Adds a vertical action line at x and y, mm, for display. */
    public void drawActionLine(double[] place) {
        actionLines.add(place);
    }

    /** Positions x, y of the vertical action lines, mm. */
    public List<double[]> actionLines() {
        return List.copyOf(actionLines);
    }

    /** Value of a parameter during the run. */
    public RampedValue ramped(Parameter parameter) {
        return values.of(parameter);
    }

    /** Value of a switch during the run: 1 on, 0 off. */
    public RampedValue ramped(SwitchSetting setting) {
        return values.of(setting);
    }

    /** Registers a constraint that can be switched on and off. */
    public void switches(SwitchedConstraint constraint) {
        tuning.switches(constraint);
        constraint.restart(system);
    }

    /**
     * Registers an action that tunes springs, attachments or masses when one of some parameters changes.
     *
     * @param parameters that the action depends on
     * @param action creates the action when the scene has settled
     */
    public void tunes(List<Parameter> parameters, Supplier<TissueTuner.Action> action) {
        RampedValue[] ramped = parameters.stream().map(values::of).toArray(RampedValue[]::new);
        tuning.whenSettled(() -> new TissueTuner(ramped, action.get()));
    }

    /** Ends the assembly and releases its temporary data. */
    public void close() {
        springCount = nodes.sheetSprings.count() + nodes.passiveSprings.count();
        nodes = null;
        tracks = Optional.empty();
    }

    /** Number of springs between nodes. */
    public int springCount() {
        return springCount;
    }

    /** Masses of tissue and what mass scaling adds to them. */
    public NodeMasses nodeMasses() {
        return nodeMasses;
    }

    /** Values that can change during the run. */
    public SceneTuning tuning() {
        return tuning;
    }
}
