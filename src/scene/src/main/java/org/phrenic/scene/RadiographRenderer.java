package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3d;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.imaging.Fluoroscope;
import org.phrenic.access.imaging.Radiograph;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Simulates a scenario and makes radiographs of it as pictures, without OpenGL. Times must be requested in ascending
 * order. Grey levels of a view are chosen at its first picture and stay, so that pictures of a breath can be compared.
 */
public final class RadiographRenderer implements AutoCloseable {
    /** Attenuation above which a pixel shows the body. */
    private static final double BODY_ATTENUATION = 0.05;

    /** Share of the body's pixels that are black. */
    private static final double BLACK_SHARE = 0.005;

    /** White over the attenuation that all but a thousandth of the body has, as tissue moves together in a breath. */
    private static final double HEADROOM = 1.05;

    /** Decimals of an angle in degrees. */
    private static final int ANGLE_DECIMALS = 3;

    /**
     * How the body is seen.
     *
     * @param leftObliqueDeg LAO positive, RAO negative
     * @param cranialDeg cranial positive, caudal negative
     * @param fieldMm width of the detector
     * @param width pixels
     * @param height pixels
     */
    public record View(double leftObliqueDeg, double cranialDeg, double fieldMm, int width, int height) {
        /** In words of the catheter laboratory, such as "LAO 30, cranial 12.5", to a thousandth of a degree. */
        public String label() {
            return words(leftObliqueDeg, "LAO ", "RAO ") + ", " + words(cranialDeg, "cranial ", "caudal ");
        }

        private static String words(double degrees, String positive, String negative) {
            String angle = angle(degrees);
            return angle.startsWith("-") ? negative + angle.substring(1) : positive + angle;
        }

        /** An angle to a thousandth of a degree. */
        public static String angle(double degrees) {
            BigDecimal rounded = BigDecimal.valueOf(degrees).setScale(ANGLE_DECIMALS, RoundingMode.HALF_EVEN);
            return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
        }
    }

    private final ScenePlayer player;
    private final Fluoroscope fluoroscope;
    private final double[] bounds;
    private final double energyKev;
    private final Map<View, double[]> levels = new HashMap<>();

    /**
     * @param energyKev photon energy, 40 to 80 keV
     * @param threads number of threads of a picture
     */
    public RadiographRenderer(Scenario scenario, SimulationRun.Progress progress, double energyKev, int threads) {
        player = new ScenePlayer(scenario, progress);
        fluoroscope = new Fluoroscope(player.surfaces(), threads);
        bounds = Surface.bounds(player.surfaces());
        this.energyKev = energyKev;
        if (!fluoroscope.leftOut().isEmpty()) {
            progress.note(
                    "Not in the radiographs, as they are open: " + String.join(", ", fluoroscope.leftOut()) + ".");
        }
    }

    /** Duration of the scenario, s. */
    public double durationS() {
        return player.durationS();
    }

    /** Simulates up to a time and takes a radiograph about the middle of the body. */
    public Radiograph take(double timeS, View view) {
        Frame frame = player.advanceTo(timeS);
        double[] middle = new double[3];
        Arrays.setAll(middle, axis -> (bounds[axis] + bounds[3 + axis]) / 2);
        CArm arm = new CArm(
                middle,
                view.leftObliqueDeg(),
                view.cranialDeg(),
                CArm.SOURCE_DETECTOR_MM,
                CArm.SOURCE_ISOCENTRE_MM,
                new CArm.Detector(view.fieldMm(), view.width(), view.height()));
        return fluoroscope.take(frame, arm, energyKev);
    }

    /**
     * A way of seeing the scene.
     *
     * @param title above the picture; empty for a picture without any annotation
     */
    public Shot shot(View view, Optional<String> title) {
        return new Shot(timeS -> picture(timeS, view, title));
    }

    private BufferedImage picture(double timeS, View view, Optional<String> title) {
        Radiograph radiograph = take(timeS, view);
        double[] range = levels.computeIfAbsent(view, any -> range(radiograph));
        byte[] grey = radiograph.grey(range[0], range[1]);
        BufferedImage picture = new BufferedImage(view.width(), view.height(), BufferedImage.TYPE_INT_RGB);
        int[] rgb = new int[grey.length];
        Arrays.setAll(rgb, i -> (grey[i] & 0xff) * 0x010101);
        picture.setRGB(0, 0, view.width(), view.height(), rgb, 0, view.width());
        String time = Annotations.timestamp(timeS, player.phase());
        title.map(text -> new Annotations(false, text, time, "", Optional.empty(), player.notInScan()))
                .ifPresent(annotations -> annotations.draw(picture, camera(view, radiograph.arm())));
        return picture;
    }

    private Camera camera(View view, CArm arm) {
        double[] c = arm.isocentre();
        Vector3d middle = new Vector3d(c[0], c[1], c[2]);
        double height = arm.pixelMm() * view.height() * CArm.SOURCE_ISOCENTRE_MM / CArm.SOURCE_DETECTOR_MM;
        return new Camera(middle, view.leftObliqueDeg(), view.cranialDeg(), height, false, middle, height);
    }

    /** Attenuations that are black and white in a picture of the body. */
    public static double[] range(Radiograph radiograph) {
        CArm arm = radiograph.arm();
        double[] body = new double[arm.columns() * arm.rows()];
        int count = 0;
        for (int row = 0; row < arm.rows(); row++) {
            for (int column = 0; column < arm.columns(); column++) {
                double value = radiograph.attenuation(column, row);
                if (value > BODY_ATTENUATION) {
                    body[count++] = value;
                }
            }
        }
        if (count == 0) {
            return new double[] {0, 1};
        }
        Arrays.sort(body, 0, count);
        return new double[] {body[(int) (BLACK_SHARE * count)], HEADROOM * body[(int) (0.999 * (count - 1))]};
    }

    @Override
    public void close() {
        player.close();
    }
}
