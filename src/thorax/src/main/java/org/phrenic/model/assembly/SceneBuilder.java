package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
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
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.RecessTracks;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.SettingValues;
import org.phrenic.parameter.SwitchSetting;

/**
 * A scene while it is put together. {@link SceneAssembly} puts the nodes in place; then the parts of the material add
 * what acts on them.
 */
public final class SceneBuilder {
    private final SettingValues settings;
    private final Thorax thorax;
    private final RampedValues values;
    private final BreathDrive drive;
    private final RibCagePose pose;
    private final Workers workers;
    private MassSpringBuilder nodes = new MassSpringBuilder();
    private int springCount;
    private final SceneTuning tuning;
    private final List<double[]> actionLines = new ArrayList<>();
    private DiaphragmPart diaphragm;
    private Optional<LungPart> lungs = Optional.empty();
    private SkinningWeights bones;
    private Optional<MovingChestWall> wall = Optional.empty();
    private Optional<CompletableFuture<RecessTracks>> tracks = Optional.empty();
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

    public SceneBuilder(
            SettingValues settings,
            Thorax thorax,
            RampedValues values,
            BreathDrive drive,
            RibCagePose pose,
            Workers workers) {
        this.settings = settings;
        this.thorax = thorax;
        this.values = values;
        this.drive = drive;
        this.pose = pose;
        this.workers = workers;
        tuning = new SceneTuning(values);
    }

    public SettingValues settings() {
        return settings;
    }

    public Thorax thorax() {
        return thorax;
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

    /** Nodes, springs and attachments as they are collected. */
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

    public SkinningWeights bones() {
        return bones;
    }

    public void setBones(SkinningWeights weights) {
        bones = weights;
    }

    /** The wall on which diaphragm and lungs slide; empty where attachments alone hold them. */
    public Optional<MovingChestWall> wall() {
        return wall;
    }

    public void setWall(Optional<MovingChestWall> chestWall) {
        wall = chestWall;
    }

    /** The paths of the lungs' border; empty without lungs or wall. */
    public Optional<RecessTracks> recessTracks() {
        return tracks.map(SceneBuilder::join);
    }

    public void setRecessTracks(Optional<CompletableFuture<RecessTracks>> future) {
        tracks = future;
    }

    /** Number of the first node of the lungs; greater than all nodes where they are not stepped. */
    public int firstLungNode() {
        return lungs.map(l -> l.firstNodes.get(0)).orElse(Integer.MAX_VALUE);
    }

    /** Puts the nodes in place, from where on forces can be added. */
    public void setSystem(ParticleSystem particles, double[] restPositions, double refreshIntervalS) {
        system = particles;
        positions = restPositions;
        refreshS = refreshIntervalS;
    }

    public ParticleSystem system() {
        return system;
    }

    public NodeLayout layout() {
        return system.layout();
    }

    /** Of all nodes, caller's order, mm. */
    public double[] positions() {
        return positions;
    }

    /** Time after which anchors and wall planes are taken anew, s. */
    public double refreshS() {
        return refreshS;
    }

    /** The vertices of the sheet that the wall stops; worked out once. Only where there is a wall. */
    public SlidingSheet slidingSheet() {
        if (slidingSheet == null) {
            slidingSheet = SlidingSheet.of(diaphragm, wall.orElseThrow(), positions);
        }
        return slidingSheet;
    }

    public RestPressure restPressure() {
        return restPressure;
    }

    public void balancePressure(RestPressure balance) {
        restPressure = balance;
    }

    /** Adds the springs of the diaphragm; the kernel that is fastest for them serves the others too. */
    public void addSheet(Springs springs) {
        sheet = springs;
        system.add(springs);
    }

    public Springs sheet() {
        return sheet;
    }

    /** Adds all other springs between nodes. */
    public void addPassive(Springs springs) {
        passive = springs;
        system.add(springs);
    }

    public Springs passive() {
        return passive;
    }

    /** Adds the rigid links of the tendon. */
    public void addLinks(RigidLinks tendon) {
        links = tendon;
        system.add(tendon);
    }

    public RigidLinks links() {
        return links;
    }

    /** Adds what holds the base of the lungs. */
    public void addLungBase(Attachments springs) {
        lungBase = springs;
        system.add(springs);
    }

    public Attachments lungBase() {
        return lungBase;
    }

    /** Says which nodes bone holds, exactly or by springs. */
    public void holdNodes(int[] held) {
        heldNodes = held;
    }

    public int[] heldNodes() {
        return heldNodes;
    }

    /** Shows a vertical action line at x and y, mm. */
    public void drawActionLine(double[] place) {
        actionLines.add(place);
    }

    public List<double[]> actionLines() {
        return actionLines;
    }

    /** The value of a parameter in the run. */
    public RampedValue ramped(Parameter parameter) {
        return values.of(parameter);
    }

    /** A switch in the run: 1 on, 0 off. */
    public RampedValue ramped(SwitchSetting setting) {
        return values.of(setting);
    }

    /** Has something set before every evaluation of the forces. */
    public void beforeForces(BreathDrive.Action action) {
        drive.beforeForces(action);
    }

    /** Says what the pressure on the abdominal face is. */
    public void measurePressure(BreathDrive.Quantity pressure) {
        drive.measurePressure(pressure);
    }

    /** Has something set step by step while a setting of {@link org.phrenic.parameter.Effect#SCENE} is on its way. */
    public void whileRamping(DoubleConsumer atTimeS) {
        tuning.whileRamping(atTimeS);
    }

    /** Has a constraint switched on and off. */
    public void switches(SwitchedConstraint constraint) {
        tuning.switches(constraint);
        constraint.restart(system);
    }

    /**
     * Has springs, attachments or masses tuned whenever one of some parameters has another value.
     *
     * @param action makes what tunes them, when the scene has settled
     */
    public void tunes(List<Parameter> parameters, Supplier<TissueTuner.Action> action) {
        RampedValue[] ramped = parameters.stream().map(values::of).toArray(RampedValue[]::new);
        tuning.whenSettled(() -> new TissueTuner(ramped, action.get()));
    }

    /** Springs whose numbers can be tuned, at rest where the scene has settled. */
    public TunableSprings tunable(Springs springs) {
        return new TunableSprings(springs, layout(), positions);
    }

    /** Attachments whose numbers can be tuned. */
    public TunableAttachments tunable(Attachments springs) {
        return new TunableAttachments(springs, positions, firstLungNode());
    }

    /** Told that all parts are added: what was collected for them is let go. */
    public void close() {
        springCount = nodes.sheetSprings.count() + nodes.passiveSprings.count();
        nodes = null;
        tracks = Optional.empty();
    }

    /** How many springs there are between nodes. */
    public int springCount() {
        return springCount;
    }

    public SceneTuning tuning() {
        return tuning;
    }

    /** Waits for a result; what the work threw is thrown here. */
    public static <T> T join(CompletableFuture<T> future) {
        try {
            return future.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            if (e.getCause() instanceof Error cause) {
                throw cause;
            }
            throw e;
        }
    }
}
