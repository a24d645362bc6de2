package org.phrenic.access.plan;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.access.ultrasound.LiverWindow;
import org.phrenic.access.ultrasound.ProbeOnSkin;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlMap;
import org.phrenic.simulation.observe.Surface;

/**
 * How a plan holds an ultrasound probe: place on the skin, angles, controls.
 *
 * @param window usual place on the skin, or empty for a point
 * @param pointRest point on the skin at end-expiration, LPS, mm, without a window
 */
public record ProbeHold(
        Optional<LiverWindow> window, double[] pointRest, ProbePose.Angles angles, UltrasoundSettings settings) {
    private static final List<String> KEYS =
            List.of("skin", "rotate_deg", "tilt_deg", "rock_deg", "depth_mm", "gain_db", "depth_gain_db_per_cm_mhz");
    /** Greatest tilt and rock to either side, degrees. */
    public static final double MOST_TILT_DEG = 80;

    /** Greatest overall gain, and attenuation, dB. */
    public static final double MOST_GAIN_DB = 60;
    /** Greatest time-gain compensation, dB/cm at 1 MHz. */
    public static final double MOST_DEPTH_GAIN = 2;

    /** A probe on a point of the skin, given at end-expiration. */
    public static ProbeHold at(double[] pointRest, ProbePose.Angles angles, UltrasoundSettings settings) {
        return new ProbeHold(Optional.empty(), pointRest, angles, settings);
    }

    static ProbeHold read(YamlMap map) {
        map.requireOnly(KEYS);
        Optional<LiverWindow> window = Optional.empty();
        double[] point = new double[0];
        if (map.has("skin") && !(map.toMap().get("skin") instanceof String)) {
            point = PlanStepYaml.point(map, "skin");
        } else {
            String label = map.text("skin", LiverWindow.RIGHT_INTERCOSTAL.label());
            window = LiverWindow.of(label);
            if (window.isEmpty()) {
                String names = Arrays.stream(LiverWindow.values())
                        .map(LiverWindow::label)
                        .collect(Collectors.joining(", "));
                throw map.bad("skin", "found '" + label + "', expected three numbers in mm or one of " + names);
            }
        }
        ProbePose.Angles angles = new ProbePose.Angles(
                within(map, "rotate_deg", 0, -360, 360),
                within(map, "tilt_deg", 0, -MOST_TILT_DEG, MOST_TILT_DEG),
                within(map, "rock_deg", 0, -MOST_TILT_DEG, MOST_TILT_DEG));
        double depth = within(
                map,
                "depth_mm",
                UltrasoundSettings.DEFAULT.depthMm(),
                UltrasoundSettings.LEAST_DEPTH_MM,
                UltrasoundSettings.GREATEST_DEPTH_MM);
        double gain = within(map, "gain_db", 0, -MOST_GAIN_DB, MOST_GAIN_DB);
        double depthGain = within(
                map, "depth_gain_db_per_cm_mhz", UltrasoundSettings.DEFAULT.depthGainDbPerCmMhz(), 0, MOST_DEPTH_GAIN);
        UltrasoundSettings settings =
                UltrasoundSettings.DEFAULT.withDepth(depth).withGain(gain).withDepthGain(depthGain);
        return new ProbeHold(window, point, angles, settings);
    }

    private static double within(YamlMap map, String key, double absent, double least, double most) {
        double value = map.number(key, absent);
        if (!(value >= least && value <= most)) {
            throw map.bad(key, "found " + value + ", expected " + least + " to " + most);
        }
        return value;
    }

    /**
     * The place on the skin of a body.
     *
     * @param surfaces surfaces of the scene, in the order of its frames
     * @param skin the skin among them
     */
    ProbeOnSkin on(List<Surface> surfaces, ScannedSkin skin) {
        return skin.at(window.map(w -> w.placeOn(surfaces)).orElse(pointRest));
    }

    /** The values in the format that {@link #read} accepts. */
    Map<String, Object> toPlain() {
        Object skin = window.isPresent() ? window.get().label() : pointRest;
        return new OrderedValues()
                .with("skin", skin)
                .with("rotate_deg", angles.rotationDeg())
                .with("tilt_deg", angles.tiltDeg())
                .with("rock_deg", angles.rockDeg())
                .with("depth_mm", settings.depthMm())
                .with("gain_db", settings.gainDb())
                .with("depth_gain_db_per_cm_mhz", settings.depthGainDbPerCmMhz());
    }
}
