package org.phrenic.model.material;

import java.util.Arrays;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.model.assembly.BreathDrive;
import org.phrenic.model.assembly.RestPressure;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;

/**
 * Transdiaphragmatic pressure on the abdominal face: the pressure at rest, balanced by the prestress of the sheet, and
 * the pressure of the breathing effort.
 */
public final class TransdiaphragmaticPressure extends ScenePart {
    public static final SwitchSetting PRESSURE = Setting.named("pressure", "Pressure", Effect.SCENE)
            .describedAs("Transdiaphragmatic pressure acts.")
            .onOff(true);
    public static final Parameter REST_PRESSURE = Parameter.named("rest_pressure_kpa", "Pressure at rest")
            .range(0, 2, "kPa")
            .initial(0.25)
            .shown(Group.BREATHING, Effect.TISSUE)
            .switchedBy(PRESSURE)
            .fitted(0.05, 1)
            .describedAs("Transdiaphragmatic pressure at end-expiration; about 3 cmH2O (0.3 kPa) in man.");
    public static final Parameter GREATEST_PRESSURE = Parameter.named("greatest_pressure_kpa", "Pressure of effort")
            .range(0, 20, "kPa")
            .initial(1.8)
            .group(Group.BREATHING)
            .switchedBy(PRESSURE)
            .fitted(0, 8)
            .describedAs("Transdiaphragmatic pressure added at the greatest effort, scaled to the model's soft"
                    + " muscle.");
    public static final Parameter PRESSURE_LEFT_OVER_RIGHT = Parameter.named(
                    "pressure_left_over_right", "Pressure left over right")
            .range(0.2, 5)
            .initial(1)
            .group(Group.BREATHING)
            .fitted(0.4, 2.5)
            .describedAs("Pressure of effort under the left hemidiaphragm over that under the right; the greater"
                    + " is what the effort makes.");

    public TransdiaphragmaticPressure() {
        super(Stage.PRESSURE, REST_PRESSURE, GREATEST_PRESSURE, PRESSURE_LEFT_OVER_RIGHT);
    }

    @Override
    public void addTo(Scene scene) {
        DiaphragmPart diaphragm = scene.diaphragm();
        int[] pressed = diaphragm.abdominalTriangles();
        double[] weight = new double[pressed.length / 3];
        Arrays.fill(weight, 1);
        FacePressure pressure = new FacePressure(scene.layout(), pressed, weight, diaphragm.abdominalLeftShares());
        scene.system().add(pressure);
        RampedValue rest = scene.ramped(REST_PRESSURE);
        RampedValue greatest = scene.ramped(GREATEST_PRESSURE);
        RampedValue sides = scene.ramped(PRESSURE_LEFT_OVER_RIGHT);
        double usual = REST_PRESSURE.defaultValue(scene.settings());
        boolean leans = scene.settings().get(WallContact.CONTACT);
        scene.balancePressure(new RestPressure(scene, pressure, rest.target(), usual, leans));
        BreathDrive.Quantity exerted =
                (time, breath) -> greatest.at(time) * (breath.pressure + breath.abdominalPressure);
        scene.drive().measurePressure((time, breath) -> rest.at(time) + exerted.at(time, breath));
        scene.drive().beforeForces((time, breath) -> {
            double leftOverRight = sides.at(time);
            double effort = exerted.at(time, breath);
            double right = Math.min(1, 1 / leftOverRight);
            pressure.setPressure(rest.at(time) + right * effort);
            pressure.setSecondaryPressure((Math.min(1, leftOverRight) - right) * effort);
        });
    }
}
