package org.phrenic.model.material;

import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.LungPart;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;

/**
 * Load that displaces the mediastinal surfaces of the lungs outward during inspiration. It stands for the heart and
 * mediastinum, which become narrower and longer and are not modelled.
 */
public final class Mediastinum extends ScenePart {
    public static final Parameter MEDIASTINUM_RIGHT = displacement("mediastinum_right_mm", "Mediastinum right")
            .describedAs(
                    "How far the mediastinal surface of the right lung is pushed out at full inspiration, where heart"
                            + " and mediastinum, which the model lacks, become narrower and longer.");
    public static final Parameter MEDIASTINUM_LEFT =
            displacement("mediastinum_left_mm", "Mediastinum left").describedAs("The same of the left lung.");

    private static Parameter.Builder displacement(String key, String label) {
        return Parameter.named(key, label).range(0, 40, "mm").initial(0).fitted(0, 40);
    }

    public Mediastinum() {
        super(Stage.LUNGS, MEDIASTINUM_RIGHT, MEDIASTINUM_LEFT);
    }

    @Override
    public void addTo(Scene scene) {
        scene.lungs().ifPresent(lungs -> {
            addLoad(scene, lungs, false, MEDIASTINUM_RIGHT);
            addLoad(scene, lungs, true, MEDIASTINUM_LEFT);
        });
    }

    /**
     * Adds the load of one lung. The load for 1 mm is proportional to the tether stiffness, so it is normalised to unit
     * stiffness first.
     */
    private static void addLoad(Scene scene, LungPart lungs, boolean left, Parameter parameter) {
        double[] load = lungs.outwardLoad(left, scene.layout().nodeCount());
        double assembled = scene.settings().get(Lungs.LUNG_STIFFNESS);
        for (int i = 0; i < load.length; i++) {
            load[i] /= assembled;
        }
        ConstantLoad outward = new ConstantLoad(scene.layout(), load);
        scene.system().add(outward);
        RampedValue distance = scene.ramped(parameter);
        RampedValue stiffness = scene.ramped(Lungs.LUNG_STIFFNESS);
        RampedValue coupling = scene.ramped(BoneAttachments.STERNUM_COUPLING);
        scene.drive().beforeForces((time, breath) -> {
            double inspired = 0.5 * (breath.activation + breath.ribTurn) * stiffness.at(time) * coupling.at(time);
            outward.setLoadFactor(inspired * distance.at(time));
        });
    }
}
