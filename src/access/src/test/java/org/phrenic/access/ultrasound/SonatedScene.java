package org.phrenic.access.ultrasound;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.access.Needle;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

/**
 * Boxes before a probe at the origin that looks along x, with its marker along z. Samples lie 0.3 mm apart, so that
 * every tenth of a millimetre that three divides is a sample.
 */
final class SonatedScene {
    static final ProbePose POSE = new ProbePose(new double[3], new double[] {1, 0, 0}, new double[] {0, 0, 1});
    static final UltrasoundSettings SETTINGS = UltrasoundSettings.DEFAULT.withDepth(0.3 * (SectorGrid.SAMPLES - 1));
    static final int CENTRAL_LINE = SectorGrid.LINES / 2;

    final List<Surface> surfaces = new ArrayList<>();

    /** Adds a box between two depths, as wide as the image and the beam. */
    SonatedScene with(String name, StructureKind kind, double from, double to) {
        return with(name, kind, Surface.Motion.STILL, from, -300, to, 300);
    }

    /** Adds a box between two depths and two lateral coordinates. */
    SonatedScene with(
            String name, StructureKind kind, Surface.Motion motion, double from, double left, double to, double right) {
        TriangleMesh box = Shapes.box(to - from, 200, right - left);
        double[] p = box.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] += from;
            p[i + 1] -= 100;
            p[i + 2] += left;
        }
        surfaces.add(new Surface(name, kind, 0, Side.MIDLINE, box.withPositions(p), motion, new boolean[0]));
        return this;
    }

    BModeImage image() {
        return image(1, Frame.still(surfaces), Optional.empty());
    }

    BModeImage image(SonatedNeedle needle) {
        return image(1, Frame.still(surfaces), Optional.of(needle));
    }

    BModeImage image(int threads, Frame frame, Optional<SonatedNeedle> needle) {
        return new Ultrasound(surfaces, CurvilinearProbe.abdominal(), threads).take(frame, POSE, SETTINGS, needle);
    }

    /** A frame in which every surface that deforms is shifted. */
    Frame shifted(double x, double y, double z) {
        double[] by = {x, y, z};
        return TestFrames.of(
                surfaces,
                0,
                0,
                0,
                surfaces.stream()
                        .map(s -> {
                            double[] p = s.rest().positions().clone();
                            Arrays.setAll(p, i -> p[i] + by[i % 3]);
                            return p;
                        })
                        .toArray(double[][]::new));
    }

    /** A needle across the middle of the image, in a plane beside it. */
    static SonatedNeedle needleAcross(double depth, double elevation, double riseDeg) {
        double rise = 20 * Math.tan(Math.toRadians(riseDeg));
        // Elevation is axial x lateral, which is -y.
        return new SonatedNeedle(
                new double[] {depth - rise, -elevation, -20},
                new double[] {depth + rise, -elevation, 20},
                Needle.standard());
    }

    /** Mean intensity within lines and depths. */
    static double mean(BModeImage image, int fromLine, int toLine, double fromMm, double toMm) {
        double sum = 0;
        int count = 0;
        for (int line = fromLine; line < toLine; line++) {
            for (double d = fromMm; d < toMm; d += 0.3) {
                sum += image.intensity(line, d);
                count++;
            }
        }
        return sum / count;
    }

    static double db(double ratio) {
        return 10 * Math.log10(ratio);
    }
}
