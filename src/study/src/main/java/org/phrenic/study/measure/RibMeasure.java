package org.phrenic.study.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.RibEnds;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Displacement and rotation of ribs and costal cartilages since rest, mean of both sides. Ribs are measured at the
 * anterior end and the most lateral point, and by their rotation vector. Pump handle rotation is about -x (raises the
 * front). Bucket handle rotation is about +y on the right (raises the side). A cartilage is measured at the mean of its
 * points. All is along the axes of the body's frame.
 */
final class RibMeasure implements SceneMeasure {
    private static final int LEVELS = 12;
    private static final int CARTILAGES = 10;
    private static final List<String> OF_RIB =
            List.of("rise_mm", "forward_mm", "widening_mm", "angle_deg", "pump_deg", "bucket_deg", "axis_deg");
    private static final List<String> OF_CARTILAGE = List.of("rise_mm", "forward_mm", "widening_mm");

    static final List<String> NAMES = names();

    private static final class Rib {
        int surface;
        int sign;
        /** Anterior end, then most lateral point, in the axes of the scan, mm. */
        double[] points;
    }

    private final MedianFrame body;
    /** Axes of the body's frame, three numbers each. */
    private final double[] axes;

    private final Map<Integer, List<Rib>> ribs = new TreeMap<>();
    private final Map<Integer, List<Integer>> cartilages = new TreeMap<>();

    RibMeasure(SceneGeometry view) {
        body = view.sheet().frame();
        axes = body.axes();
        for (int i : view.indicesOf(StructureKind.RIB)) {
            Surface s = view.surface(i);
            if (s.motion() == Surface.Motion.RIGID && s.side() != Side.MIDLINE) {
                ribs.computeIfAbsent(s.level(), level -> new ArrayList<>()).add(rib(i, s));
            }
        }
        for (int i : view.indicesOf(StructureKind.COSTAL_CARTILAGE)) {
            cartilages
                    .computeIfAbsent(view.surface(i).level(), level -> new ArrayList<>())
                    .add(i);
        }
    }

    private Rib rib(int index, Surface s) {
        Rib rib = new Rib();
        rib.surface = index;
        rib.sign = s.side().sign();
        double[] p = s.rest().positions();
        int lateral = SceneGeometry.mostLateral(p, rib.sign);
        double[] end = body.toScan(RibEnds.find(s.rest(), s.side()).anterior());
        double[] side = body.toScan(new double[] {p[lateral], p[lateral + 1], p[lateral + 2]});
        rib.points = new double[] {end[0], end[1], end[2], side[0], side[1], side[2]};
        return rib;
    }

    private static List<String> names() {
        List<String> names = new ArrayList<>();
        IntStream.rangeClosed(1, LEVELS)
                .forEach(n -> OF_RIB.forEach(what -> names.add(SceneGeometry.name("rib", n, what))));
        IntStream.rangeClosed(1, CARTILAGES)
                .forEach(n -> OF_CARTILAGE.forEach(what -> names.add(SceneGeometry.name("cartilage", n, what))));
        return List.copyOf(names);
    }

    @Override
    public void measure(SceneGeometry view, Frame frame, Map<String, Double> values) {
        ribs.forEach((level, pair) -> {
            double[] mean = new double[OF_RIB.size() - 1];
            pair.forEach(rib -> add(frame.pose(rib.surface), rib, 1.0 / pair.size(), mean));
            for (int i = 0; i < mean.length; i++) {
                values.put(SceneGeometry.name("rib", level, OF_RIB.get(i)), mean[i]);
            }
            values.put(
                    SceneGeometry.name("rib", level, "axis_deg"),
                    StrictMath.toDegrees(StrictMath.atan2(mean[4], Math.abs(mean[5]))));
        });
        cartilages.forEach((level, pair) -> {
            double[] mean = new double[3];
            for (int surface : pair) {
                add(view, surface, 1.0 / pair.size(), mean);
            }
            for (int i = 0; i < mean.length; i++) {
                values.put(SceneGeometry.name("cartilage", level, OF_CARTILAGE.get(i)), mean[i]);
            }
        });
    }

    private void add(float[] pose, Rib rib, double weight, double[] mean) {
        double[] moved = new double[6];
        Frame.transform(pose, rib.points, moved);
        for (int k = 0; k < moved.length; k++) {
            moved[k] -= rib.points[k];
        }
        double[] turn = rotationVector(pose);
        mean[0] += weight * along(2, moved, 0);
        mean[1] -= weight * along(1, moved, 0);
        mean[2] += weight * rib.sign * along(0, moved, 3);
        mean[3] += weight * Math.sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
        mean[4] -= weight * along(0, turn, 0);
        mean[5] -= weight * rib.sign * along(1, turn, 0);
    }

    /** Component of a vector in an array along an axis of the body's frame. */
    private double along(int axis, double[] v, int at) {
        return MedianFrame.along(axes, axis, v[at], v[at + 1], v[at + 2]);
    }

    private static void add(SceneGeometry view, int surface, double weight, double[] mean) {
        double[] rest = view.surface(surface).rest().positions();
        double[] now = view.positions(surface);
        int count = rest.length / 3;
        double each = weight / count;
        int sign = view.surface(surface).side().sign();
        for (int k = 0; k < rest.length; k += 3) {
            mean[0] += each * (now[k + 2] - rest[k + 2]);
            mean[1] += each * (rest[k + 1] - now[k + 1]);
            mean[2] += each * sign * (now[k] - rest[k]);
        }
    }

    /** Rotation vector (axis times angle) of a pose, degrees. */
    static double[] rotationVector(float[] pose) {
        double x = pose[9] - pose[6];
        double y = pose[2] - pose[8];
        double z = pose[4] - pose[1];
        double sine2 = Math.sqrt(x * x + y * y + z * z);
        double angle = StrictMath.toDegrees(StrictMath.atan2(sine2, (double) pose[0] + pose[5] + pose[10] - 1));
        double scale = sine2 == 0 ? 0 : angle / sine2;
        return new double[] {scale * x, scale * y, scale * z};
    }
}
