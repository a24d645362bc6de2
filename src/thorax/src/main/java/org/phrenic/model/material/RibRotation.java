package org.phrenic.model.material;

import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.RibGains;
import org.phrenic.breathing.BreathState;
import org.phrenic.model.assembly.BreathDrive;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;

/** Rotation of the ribs about their helical axes, driven by the breath. */
public final class RibRotation extends ScenePart {
    public static final SwitchSetting RIBS = Setting.named("ribs", "Ribs", Effect.DRIVE)
            .describedAs("The ribs turn about their helical axes.")
            .onOff(true);
    public static final Parameter RIB_ROTATION = factor("rib_rotation", "Rib rotation", 1.5)
            .switchedBy(RIBS)
            .fitted(0, 1.5, 1)
            .describedAs("Multiplies the turn of every rib.");
    public static final Parameter UPPER_RIB_ROTATION = factor("upper_rib_rotation", "Upper ribs", 2)
            .fitted(0.3, 1.7)
            .describedAs("Multiplies besides the turn of ribs 1 to 3, of rib 4 by two thirds of that, of rib 5 by"
                    + " one third.");
    public static final Parameter LOWER_RIB_ROTATION = factor("lower_rib_rotation", "Lower ribs", 2)
            .fitted(0.3, 1.7)
            .describedAs("Multiplies besides the turn of ribs 9 to 12, of rib 8 by two thirds of that, of rib 7"
                    + " by one third.");
    public static final Parameter RIB_LEFT_OVER_RIGHT = factor("rib_left_over_right", "Ribs left over right", 5)
            .range(0.2, 5)
            .fitted(0.6, 1.6)
            .describedAs("Turn of the left ribs over that of the right; the side that turns farther takes"
                    + " rib_rotation.");
    public static final Parameter BUCKET_HANDLE = factor("bucket_handle", "Bucket handle", 3)
            .fitted(0, 2)
            .describedAs("Multiplies what each rib turns to raise its side (about the antero-posterior axis), and"
                    + " leaves what raises its front. People's axes differ by about 10 degrees.");

    private static Parameter.Builder factor(String key, String label, double maximum) {
        return Parameter.named(key, label).range(0, maximum).initial(1).group(Group.RIBS);
    }

    public RibRotation() {
        super(Stage.LOADS, RIB_ROTATION, UPPER_RIB_ROTATION, LOWER_RIB_ROTATION, RIB_LEFT_OVER_RIGHT, BUCKET_HANDLE);
    }

    /** The drive of a scene's rib cage. */
    static final class Drive implements RibCagePose.RibDrive {
        private final BreathDrive breath;
        private final RampedValue all;
        private final RampedValue upper;
        private final RampedValue lower;
        private final RampedValue sides;
        private final RampedValue bucketHandle;

        Drive(RampedValues values, BreathDrive breath) {
            this.breath = breath;
            all = values.of(RIB_ROTATION);
            upper = values.of(UPPER_RIB_ROTATION);
            lower = values.of(LOWER_RIB_ROTATION);
            sides = values.of(RIB_LEFT_OVER_RIGHT);
            bucketHandle = values.of(BUCKET_HANDLE);
        }

        @Override
        public void at(double time, double[] amplitudeAndRate) {
            BreathState state = breath.breathAt(time);
            double rotation = all.at(time);
            amplitudeAndRate[0] = rotation * state.ribTurn;
            amplitudeAndRate[1] = rotation * state.ribTurnRate + all.rate(time) * state.ribTurn;
        }

        @Override
        public boolean gains(double time, RibGains gains) {
            double ofUpper = upper.at(time);
            double ofLower = lower.at(time);
            double ofSides = sides.at(time);
            double ofBucket = bucketHandle.at(time);
            if (ofUpper == 1 && ofLower == 1 && ofSides == 1 && ofBucket == 1) {
                return false;
            }
            gains.setBucket(ofBucket);
            gains.setFactors(ofUpper, ofLower, ofSides);
            gains.setRates(upper.rate(time), lower.rate(time), sides.rate(time));
            return true;
        }
    }
}
