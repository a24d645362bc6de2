package org.phrenic.cli.option;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.access.Needle;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.LiverWindow;
import org.phrenic.access.ultrasound.ProbeOnSkin;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.observe.Surface;
import picocli.CommandLine.Option;

/** Options for an ultrasound probe: its place on the skin and its angles, the beam, the controls, a needle. */
public final class ProbeOptions {
    private static final double LEAST_NEEDLE_MM = 1;
    private static final double MOST_NEEDLE_MM = 400;

    @Option(
            names = "--skin",
            paramLabel = "PLACE",
            description = "Where the probe is: X,Y,Z on the skin at end-expiration (LPS, mm), right-intercostal, "
                    + "right-subcostal or subxiphoid. Default: right-intercostal.")
    private String skin = LiverWindow.RIGHT_INTERCOSTAL.label();

    @Option(
            names = "--rotate",
            paramLabel = "DEG",
            description = "About the skin's normal, anticlockwise from outside. 0: longitudinal, marker to the head;"
                    + " 90: transverse, on the front marker to the right. Default: 0.")
    private String rotate = "0";

    @Option(names = "--tilt", paramLabel = "DEG", description = "Out of the image plane, -80 to 80. Default: 0.")
    private String tilt = "0";

    @Option(names = "--rock", paramLabel = "DEG", description = "In the plane, toward the marker. Default: 0.")
    private String rock = "0";

    @Option(names = "--frequency", paramLabel = "MHZ", description = "2 to 5 MHz. Default: 3.5.")
    private String frequency = "3.5";

    @Option(names = "--focus", paramLabel = "MM", description = "Depth of the focus. Default: 80.")
    private String focus = "80";

    @Option(names = "--thickness", paramLabel = "MM", description = "Of the beam at the focus. Default: 3.5.")
    private String thickness = "3.5";

    @Option(names = "--depth", paramLabel = "MM", description = "Depth of the image, 40 to 300. Default: 150.")
    private String depth = "150";

    @Option(names = "--gain", paramLabel = "DB", description = "Default: 0.")
    private String gain = "0";

    @Option(
            names = "--depth-gain",
            paramLabel = "DB",
            description = "Time-gain compensation, dB/cm at 1 MHz. Default: 0.5, as liver.")
    private String depthGain = "0.5";

    @Option(names = "--dynamic-range", paramLabel = "DB", description = "From black to white. Default: 60.")
    private String dynamicRange = "60";

    @Option(
            names = "--needle",
            paramLabel = "X,Y,Z,X,Y,Z",
            description = "A needle of 18 G from its entry to its tip (LPS, mm).")
    private String needle;

    /** The probe. */
    public CurvilinearProbe probe() {
        CurvilinearProbe usual = CurvilinearProbe.abdominal();
        return new CurvilinearProbe(
                usual.radiusMm(),
                usual.sectorDeg(),
                OptionValues.number("--frequency", frequency, 2, 5),
                OptionValues.number("--focus", focus, 20, 200),
                OptionValues.number("--thickness", thickness, 0.5, 20));
    }

    /** Its angles to the skin. */
    public ProbePose.Angles angles() {
        return new ProbePose.Angles(
                OptionValues.number("--rotate", rotate, -360, 360),
                OptionValues.number("--tilt", tilt, -ProbeHold.MOST_TILT_DEG, ProbeHold.MOST_TILT_DEG),
                OptionValues.number("--rock", rock, -ProbeHold.MOST_TILT_DEG, ProbeHold.MOST_TILT_DEG));
    }

    /** The controls of the scanner. */
    public UltrasoundSettings settings() {
        return new UltrasoundSettings(
                OptionValues.number(
                        "--depth", depth, UltrasoundSettings.LEAST_DEPTH_MM, UltrasoundSettings.GREATEST_DEPTH_MM),
                OptionValues.number("--gain", gain, -ProbeHold.MOST_GAIN_DB, ProbeHold.MOST_GAIN_DB),
                OptionValues.number("--depth-gain", depthGain, 0, ProbeHold.MOST_DEPTH_GAIN),
                OptionValues.number("--dynamic-range", dynamicRange, 20, 120));
    }

    /** The needle, if there is one. */
    public Optional<SonatedNeedle> needle() {
        return Optional.ofNullable(needle).map(text -> {
            double[] p = numbers("--needle", text, 6);
            double lengthMm = StrictMath.hypot(StrictMath.hypot(p[3] - p[0], p[4] - p[1]), p[5] - p[2]);
            if (lengthMm < LEAST_NEEDLE_MM || lengthMm > MOST_NEEDLE_MM) {
                throw new BadInputException(Numbers.format(
                        "--needle: found entry and tip %.3g mm apart, expected %.0f to %.0f mm",
                        lengthMm, LEAST_NEEDLE_MM, MOST_NEEDLE_MM));
            }
            return new SonatedNeedle(Arrays.copyOfRange(p, 0, 3), Arrays.copyOfRange(p, 3, 6), Needle.standard());
        });
    }

    /** Checks all values that do not depend on the body. */
    public void validate() {
        probe();
        angles();
        settings();
        needle();
        if (LiverWindow.of(skin).isEmpty()) {
            place(skin);
        }
    }

    /** The place on the skin of a body. */
    public ProbeOnSkin place(List<Surface> surfaces) {
        return new ProbeOnSkin(
                surfaces, LiverWindow.of(skin).map(w -> w.placeOn(surfaces)).orElseGet(() -> place(skin)));
    }

    private static double[] place(String text) {
        if (!text.contains(",")) {
            String names =
                    Arrays.stream(LiverWindow.values()).map(LiverWindow::label).collect(Collectors.joining(", "));
            throw new BadInputException("--skin: found '" + text + "', expected X,Y,Z in mm or one of " + names);
        }
        return numbers("--skin", text, 3);
    }

    private static double[] numbers(String option, String text, int count) {
        List<String> parts = OptionValues.split(text);
        if (parts.size() != count) {
            throw new BadInputException(
                    option + ": found " + parts.size() + " numbers in '" + text + "', expected " + count + " in mm");
        }
        return parts.stream()
                .mapToDouble(part -> OptionValues.number(option, part))
                .toArray();
    }
}
