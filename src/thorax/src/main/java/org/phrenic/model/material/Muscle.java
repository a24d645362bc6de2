package org.phrenic.model.material;

import org.phrenic.engine.force.Springs;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;

/** The diaphragm's muscle: its fibres shorten with the activation of the breath. */
public final class Muscle extends ScenePart {
    public static final SwitchSetting MUSCLE = Setting.named("muscle", "Muscle", Effect.DRIVE)
            .describedAs("The diaphragm's muscle is driven.")
            .onOff(true);
    public static final Parameter MUSCLE_ACTIVATION = Parameter.named("muscle_activation", "Muscle activation")
            .range(0, 0.8)
            .initial(0.66)
            .group(Group.MUSCLE)
            .switchedBy(MUSCLE)
            .fitted(0.1, 0.8, 1)
            .describedAs("Shortening of the muscle's rest length at full drive, as a share of it; fitted on the virtual"
                    + " man alone.");
    public static final Parameter LEFT_OVER_RIGHT = Parameter.named("left_over_right", "Left over right")
            .range(0.2, 5)
            .initial(1.12)
            .shown(Group.MUSCLE, Effect.TISSUE)
            .fitted(0.5, 2, 1)
            .describedAs("Activation of the left hemidiaphragm over that of the right; deep breaths move the left"
                    + " dome 1.07 times as far in men, 1.12 in women (Boussuges 2009). The stronger side takes"
                    + " muscle_activation.");
    public static final Parameter FRONT_OVER_BACK = Parameter.named("front_over_back", "Front over back")
            .range(0.2, 5)
            .initial(1)
            .shown(Group.MUSCLE, Effect.TISSUE)
            .fitted(0.4, 2.5)
            .describedAs("Activation of the diaphragm's front over that of its back, changing smoothly over 50 mm"
                    + " to each side of its middle. The stronger takes what left_over_right leaves it.");

    public Muscle() {
        super(Stage.SPRINGS, MUSCLE_ACTIVATION, LEFT_OVER_RIGHT, FRONT_OVER_BACK);
    }

    @Override
    public void addTo(Scene scene) {
        Springs sheet = scene.sheetSprings();
        RampedValue activation = scene.ramped(MUSCLE_ACTIVATION);
        scene.drive().beforeForces((time, breath) -> sheet.setActivation(activation.at(time) * breath.activation));
    }
}
