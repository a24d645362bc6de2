package org.phrenic.simulation.assembly;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.organ.DiaphragmPart;

/**
 * Makes the tissue of a running scene stiffer, heavier or more damped without moving its rest shape. A spring pulls
 * with {@code k f (l - L) + T}: {@code L} and {@code T} its length and tension as the scene settled at end-expiration,
 * {@code f} the factor by which its tissue is stiffer than as assembled; T goes with the pressure at rest. Springs to
 * bone likewise. With all factors at 1 every number is the one assembled.
 */
final class TissueTuning {
    private static final Knob[] SHEET = {
        Knob.STIFFNESS, Knob.TENDON_RATIO, Knob.REST_PRESSURE, Knob.LEFT_OVER_RIGHT, Knob.FRONT_OVER_BACK
    };
    private static final Knob[] PASSIVE = {Knob.STIFFNESS, Knob.LUNG_STIFFNESS};
    private static final Knob[] BONE = {Knob.STIFFNESS, Knob.LUNG_STIFFNESS, Knob.COUPLING};
    private static final Knob[] MASSES = {
        Knob.MASS, Knob.TENDON_RATIO, Knob.STIFFNESS, Knob.LUNG_STIFFNESS, Knob.DAMPING
    };

    private final ParticleSystem system;
    private final SceneForces forces;
    private final DiaphragmPart diaphragm;
    private final boolean physical;
    private final int firstLungNode;
    private final double[] base;
    private final double[] applied;
    private final TunableSprings sheet;
    private final TunableSprings passive;
    private final TunableAttachments bone;
    private final TunableAttachments restoring;
    private final TunableAttachments lungBase;
    private final double[] mass;

    TissueTuning(Scene scene, Scenario scenario) {
        system = scene.system();
        forces = scene.forces();
        diaphragm = scene.diaphragm();
        physical = scenario.material() == TissueMaterial.PHYSICAL;
        firstLungNode = scene.lungs().map(l -> l.firstNodes.get(0)).orElse(Integer.MAX_VALUE);
        base = new double[Knob.values().length];
        for (Knob knob : Knob.values()) {
            base[knob.index()] = knob.valueIn(scenario);
        }
        applied = base.clone();
        NodeLayout layout = system.layout();
        sheet = new TunableSprings(forces.sheet(), layout, scene.restPositions());
        passive = forces.passive()
                .map(s -> new TunableSprings(s, layout, scene.restPositions()))
                .orElse(null);
        bone = forces.boneAttachments()
                .map(a -> new TunableAttachments(a, scene.restPositions()))
                .orElse(null);
        restoring = forces.restoring()
                .map(a -> new TunableAttachments(a, scene.restPositions()))
                .orElse(null);
        lungBase = forces.lungBase()
                .map(a -> new TunableAttachments(a, scene.restPositions()))
                .orElse(null);
        mass = system.masses().clone();
    }

    /**
     * Gives all tissue the numbers that go with values of the knobs; what has them already is left alone.
     *
     * @param value of each {@link Knob}, in its {@link Knob#index}
     */
    void apply(double[] value) {
        double muscle = factor(value, Knob.STIFFNESS);
        double tendon = muscle * factor(value, Knob.TENDON_RATIO);
        double lung = physical ? factor(value, Knob.LUNG_STIFFNESS) : muscle;
        if (differsFromApplied(value, SHEET)) {
            tuneSheet(value, muscle, tendon);
        }
        if (passive != null && differsFromApplied(value, PASSIVE)) {
            tunePassive(isAsAssembled(value, PASSIVE), muscle, lung);
        }
        if (differsFromApplied(value, BONE)) {
            double coupling = value[Knob.COUPLING.index()];
            if (bone != null) {
                bone.tune(isAsAssembled(value, BONE), muscle, lung, coupling);
            }
            if (restoring != null) {
                restoring.tune(isAsAssembled(value, BONE), muscle, muscle, 1);
            }
            if (lungBase != null) {
                lungBase.tune(isAsAssembled(value, BONE), muscle, lung, 1);
            }
        }
        if (differsFromApplied(value, MASSES)) {
            tuneMasses(value, isAsAssembled(value, MASSES));
        }
        System.arraycopy(value, 0, applied, 0, applied.length);
    }

    private double factor(double[] value, Knob knob) {
        return value[knob.index()] / base[knob.index()];
    }

    private boolean differsFromApplied(double[] value, Knob[] knobs) {
        return differs(value, applied, knobs);
    }

    private boolean isAsAssembled(double[] value, Knob[] knobs) {
        return !differs(value, base, knobs);
    }

    private static boolean differs(double[] p, double[] q, Knob[] knobs) {
        for (Knob knob : knobs) {
            if (Double.compare(p[knob.index()], q[knob.index()]) != 0) {
                return true;
            }
        }
        return false;
    }

    private void tuneSheet(double[] value, double muscle, double tendon) {
        RestPressure rest = forces.restPressure().orElse(null);
        double pressure = value[Knob.REST_PRESSURE.index()];
        double leftOverRight = value[Knob.LEFT_OVER_RIGHT.index()];
        double frontOverBack = value[Knob.FRONT_OVER_BACK.index()];
        if (rest != null) {
            rest.scaleLoad(pressure);
        }
        if (isAsAssembled(value, SHEET)) {
            sheet.restoreAssembled();
            return;
        }
        for (int e = 0; e < sheet.count; e++) {
            double more = rest == null ? 0 : rest.additionalTension(e, pressure);
            sheet.set(e, diaphragm.isTendonEdge(e) ? tendon : muscle, more);
            sheet.shortening[e] = diaphragm.contractileShare(e, leftOverRight, frontOverBack)
                    * RestPressure.limitedRestLength(sheet.lengthAtRest[e], sheet.restLength[e]);
        }
        sheet.apply();
    }

    private void tunePassive(boolean asAssembled, double muscle, double lung) {
        if (asAssembled) {
            passive.restoreAssembled();
            return;
        }
        for (int e = 0; e < passive.count; e++) {
            boolean ofLung = passive.nodes[2 * e] >= firstLungNode || passive.nodes[2 * e + 1] >= firstLungNode;
            passive.set(e, ofLung ? lung : muscle, 0);
        }
        passive.apply();
    }

    private void tuneMasses(double[] value, boolean asAssembled) {
        double all = factor(value, Knob.MASS);
        // Tissue of another stiffness is as much heavier in the physical material, so that all has one wave speed.
        double tendon = physical ? all * factor(value, Knob.TENDON_RATIO) : all;
        double lung = physical ? all * factor(value, Knob.LUNG_STIFFNESS) / factor(value, Knob.STIFFNESS) : all;
        int firstSheet = diaphragm.firstNode;
        int pastSheet = firstSheet + diaphragm.diaphragm.sheet().vertexCount();
        NodeLayout layout = system.layout();
        for (int i = 0; i < mass.length; i++) {
            int node = layout.caller(i);
            boolean inTendon =
                    node >= firstSheet && node < pastSheet && diaphragm.diaphragm.isTendon(node - firstSheet);
            double f = asAssembled ? 1 : node >= firstLungNode ? lung : inTendon ? tendon : all;
            system.setMass(i, f * mass[i]);
        }
        double damping = value[Knob.DAMPING.index()];
        if (physical) {
            system.setViscosityPerMass(damping);
        } else {
            system.setViscosity(damping);
        }
    }

    /** Springs to bone as assembled, and as they pull at rest. */
    private final class TunableAttachments {
        private final Attachments springs;
        private final int[] nodes;
        private final double[] assembled;
        private final double[] stretch;
        private final double coupling;
        private final double[] stiffness;
        private final double[] constant;

        TunableAttachments(Attachments springs, double[] positions) {
            this.springs = springs;
            nodes = springs.callerNodes();
            assembled = springs.stiffnesses();
            coupling = springs.stiffnessFactor();
            stretch = springs.anchorsAt(0);
            for (int i = 0; i < stretch.length; i++) {
                stretch[i] -= positions[3 * nodes[i / 3] + i % 3];
            }
            stiffness = assembled.clone();
            constant = new double[stretch.length];
        }

        void tune(boolean asAssembled, double muscle, double lung, double nowCoupling) {
            for (int i = 0; i < nodes.length; i++) {
                double f = asAssembled ? 1 : nodes[i] >= firstLungNode ? lung : muscle;
                stiffness[i] = f * assembled[i];
                for (int c = 3 * i; c < 3 * i + 3; c++) {
                    constant[c] = asAssembled ? 0 : (coupling * assembled[i] - nowCoupling * stiffness[i]) * stretch[c];
                }
            }
            springs.setStiffnessFactor(nowCoupling);
            springs.setCoefficients(stiffness, constant);
        }
    }

    /** Values of all knobs as assembled, each in its slot. */
    double[] assembledValues() {
        return Arrays.copyOf(base, base.length);
    }
}
