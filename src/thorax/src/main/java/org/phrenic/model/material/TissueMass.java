package org.phrenic.model.material;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.force.SlowMotionRelease;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TissueTuner;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Parameter;

/** Masses and viscous damping of all nodes. */
public final class TissueMass extends ScenePart {
    public static final Parameter AREA_DENSITY = Parameter.named("area_density_kg_per_m2", "Mass per area")
            .range(3, 1000, "kg/m^2")
            .initial(3.15)
            .limitsStep()
            .describedAs("Mass per area of a face; nodes whose springs would not bear the time step are heavier"
                    + " (mass_scaling_s).");
    public static final Parameter NODE_MASS = Parameter.named("node_mass_kg", "Node mass")
            .range(0.001, 10, "kg")
            .initial(0.1)
            .limitsStep()
            .describedAs("One mass for every node (Villard, Bourne and Bello 2009).");
    public static final Parameter DAMPING = Parameter.named("damping_ns_per_m", "Damping")
            .range(0, 100, "N s/m")
            .initial(0.02)
            .effect(Effect.TISSUE)
            .describedAs("Viscous damping of a node (Villard, Bourne and Bello 2009, eq. 4).");
    public static final Parameter DAMPING_RATE = Parameter.named("damping_rate_per_s", "Damping over mass")
            .range(0, 200, "1/s")
            .initial(5)
            .effect(Effect.TISSUE)
            .describedAs("Viscous damping over mass; less in a diaphragm of more than usual size.");

    /** Mass per area. Mass scales with the relative stiffness, so that all tissue has the same wave speed. */
    static final TissueMass PER_AREA = new TissueMass(AREA_DENSITY, DAMPING_RATE, true);

    /** Uniform node mass. */
    static final TissueMass PER_NODE = new TissueMass(NODE_MASS, DAMPING, false);

    private final Parameter damping;
    private final boolean perArea;

    private TissueMass(Parameter mass, Parameter damping, boolean perArea) {
        super(Stage.BOUNDARY, mass, damping);
        this.damping = damping;
        this.perArea = perArea;
    }

    /** A large sheet has slower modes; with less damping they return as fast as those of a usual one. */
    private void setDamping(Scene scene, double value) {
        ParticleSystem system = scene.system();
        if (perArea) {
            double size = scene.diaphragm().relativeSize();
            system.setViscosityPerMass(value / (size * size));
        } else {
            system.setViscosity(value);
        }
    }

    @Override
    public void addTo(Scene scene) {
        setDamping(scene, scene.settings().get(damping));
        if (perArea) {
            lightenTendon(scene);
            double time = scene.settings().get(Numerics.DAMPING_TIME);
            if (time > 0) {
                scene.system().add(new SlowMotionRelease(scene.system(), time));
            }
        }
        List<Parameter> tuned = new ArrayList<>(parameters());
        if (perArea) {
            tuned.addAll(List.of(SheetSprings.TENDON_RATIO, SheetSprings.MUSCLE_STIFFNESS, Lungs.LUNG_STIFFNESS));
        }
        scene.tunes(tuned, () -> tuning(scene));
    }

    /** The tendon's masses go with its stiffness; its translation need not bear them. */
    private static void lightenTendon(Scene scene) {
        double lightness = scene.settings().get(Numerics.TENDON_LIGHTNESS);
        DiaphragmPart sheet = scene.diaphragm();
        int[] tendon = IntStream.range(0, sheet.diaphragm.sheet().vertexCount())
                .filter(i -> sheet.diaphragm.isTendon(i) && !sheet.diaphragm.isInserted(i))
                .toArray();
        if (lightness > 1 && tendon.length > 0) {
            scene.system().setSelectiveMass(MassSpringBuilder.offset(tendon, sheet.firstNode), lightness);
        }
    }

    private TissueTuner.Action tuning(Scene scene) {
        ParticleSystem system = scene.system();
        NodeLayout layout = system.layout();
        DiaphragmPart sheet = scene.diaphragm();
        int firstLungNode = scene.firstLungNode();
        int pastSheet = sheet.firstNode + sheet.diaphragm.sheet().vertexCount();
        return (value, assembled, asAssembled) -> {
            double all = value[0] / assembled[0];
            // The mass of tissue goes with its stiffness relative to muscle. The least mass goes with the lungs'
            // stiffness, and with the tendon's relative to muscle.
            double tendon = perArea ? value[2] / assembled[2] : 1;
            double lungSprings = perArea ? value[4] / assembled[4] : 1;
            double lung = perArea ? lungSprings / (value[3] / assembled[3]) : 1;
            for (int i = 0; i < layout.nodeCount(); i++) {
                int node = layout.caller(i);
                boolean inTendon =
                        node >= sheet.firstNode && node < pastSheet && sheet.diaphragm.isTendon(node - sheet.firstNode);
                boolean inLung = node >= firstLungNode;
                double tissue = asAssembled ? 1 : inLung ? lung : inTendon ? tendon : 1;
                double least = asAssembled ? 1 : inLung ? lungSprings : inTendon ? tendon : 1;
                system.setMass(i, scene.nodeMasses().of(node, asAssembled ? 1 : all, tissue, least));
            }
            setDamping(scene, value[1]);
        };
    }
}
