package org.phrenic.model.material;

import org.phrenic.engine.ForceField;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;

/**
 * Weight of the diaphragm and of the liver suspended from it, in the direction given by the posture: {@code F = m g d}
 * with {@code d = (sin r, cos r sin t, -cos r cos t)} in axes L, P, S, where {@code t} is the tilt and {@code r} the
 * roll. The sheet has {@value #SHEET_KG_PER_M2} kg/m², the physical mass of muscle without mass scaling, half of it on
 * each face. A share {@value #LIVER_SHARE} of the liver's mass, at {@value #LIVER_KG_PER_M3} kg/m³, is distributed over
 * the diaphragm above it by area.
 */
public final class Gravity extends ScenePart {
    public static final Parameter ACCELERATION = Parameter.named("gravity_m_per_s2", "Gravity")
            .range(0, 9.81, "m/s^2")
            .initial(0)
            .shown(Group.BREATHING, Effect.SCENE)
            .describedAs("Weight of diaphragm and liver in the posture given; 0 leaves the body as it was scanned.");
    public static final Parameter TILT = angle("gravity_tilt_deg", "Gravity tilt", 180)
            .describedAs(
                    "Direction of gravity in the sagittal plane: 0 standing, 90 supine, -90 prone, 180 head down.");
    public static final Parameter ROLL = angle("gravity_roll_deg", "Gravity roll", 90)
            .describedAs("Direction of gravity toward a side: 90 lying on the left, -90 on the right.");

    private static final double SHEET_KG_PER_M2 = 3.15;
    private static final int FACES = 2;
    private static final double LIVER_KG_PER_M3 = 1060;
    /**
     * Share of the liver's weight that the diaphragm carries; abdominal contents of similar density carry the rest.
     * Chosen: under the full weight, 1 kPa against 0.25 kPa at rest, the model's soft sheet inverts.
     */
    private static final double LIVER_SHARE = 0.1;

    private static Parameter.Builder angle(String key, String label, double maximum) {
        return Parameter.named(key, label)
                .range(-maximum, maximum, "deg")
                .initial(0)
                .shown(Group.BREATHING, Effect.SCENE);
    }

    public Gravity() {
        super(Stage.LOADS, ACCELERATION, TILT, ROLL);
    }

    @Override
    public void addTo(Scene scene) {
        scene.system().add(new Weight(scene));
    }

    /** Weights of the nodes, computed when gravity first acts. */
    private static final class Weight implements ForceField {
        private final Scene scene;
        private final RampedValue acceleration;
        private final RampedValue tilt;
        private final RampedValue roll;
        private final ConstantLoad[] alongAxis = new ConstantLoad[3];
        private boolean acts;

        Weight(Scene scene) {
            this.scene = scene;
            acceleration = scene.ramped(ACCELERATION);
            tilt = scene.ramped(TILT);
            roll = scene.ramped(ROLL);
        }

        @Override
        public void prepare(double time) {
            double g = acceleration.at(time);
            acts = g != 0;
            if (!acts) {
                return;
            }
            if (alongAxis[0] == null) {
                weigh();
            }
            double t = Math.toRadians(tilt.at(time));
            double r = Math.toRadians(roll.at(time));
            alongAxis[0].setLoadFactor(g * StrictMath.sin(r));
            alongAxis[1].setLoadFactor(g * StrictMath.cos(r) * StrictMath.sin(t));
            alongAxis[2].setLoadFactor(-g * StrictMath.cos(r) * StrictMath.cos(t));
        }

        private void weigh() {
            double[] grams = masses(
                    scene.diaphragm(),
                    scene.liver().orElse(null),
                    scene.layout().nodeCount());
            for (int axis = 0; axis < 3; axis++) {
                double[] load = new double[3 * grams.length];
                for (int node = 0; node < grams.length; node++) {
                    load[3 * node + axis] = grams[node];
                }
                alongAxis[axis] = new ConstantLoad(scene.layout(), load);
            }
        }

        @Override
        public void addForces(double[] x, double[] v, double[] force, int block) {
            if (acts) {
                for (ConstantLoad load : alongAxis) {
                    load.addForces(x, v, force, block);
                }
            }
        }
    }

    /**
     * Mass of each node of a scene, g.
     *
     * @param liver null without a liver
     */
    static double[] masses(DiaphragmPart diaphragm, LiverPart liver, int nodes) {
        TriangleMesh sheet = diaphragm.diaphragm.sheet();
        double[] areas = MeshMeasure.vertexAreas(sheet);
        double[] grams = new double[nodes];
        for (int i = 0; i < areas.length; i++) {
            // 1 kg/m² is 0.001 g/mm².
            grams[diaphragm.firstNode + i] = SHEET_KG_PER_M2 / FACES * areas[i] / 1000;
        }
        if (liver != null) {
            double mass =
                    LIVER_SHARE * LIVER_KG_PER_M3 * Math.abs(MeshMeasure.signedVolume(liver.structure.mesh())) * 1e-6;
            liver.hang(mass, grams);
        }
        return grams;
    }
}
