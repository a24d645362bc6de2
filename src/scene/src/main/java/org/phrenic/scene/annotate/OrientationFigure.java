package org.phrenic.scene.annotate;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.phrenic.scene.camera.Camera;

/**
 * A small standing figure with the orientation of the patient. Limbs are rounded bars, drawn back to front. Nose and
 * feet point forward.
 */
final class OrientationFigure {
    /**
     * Bars in body coordinates (x left, y back, z up; height 2, centred at the origin): both end points, radius, shade.
     */
    private static final double[][] LIMBS = {
        {0, 0, 0.78, 0, 0, 0.80, 0.17, 1}, // head
        {0, -0.16, 0.76, 0, -0.21, 0.74, 0.04, 0.62}, // nose
        {0, 0, 0.55, 0, 0, 0.62, 0.075, 0.9}, // neck
        {-0.17, 0, 0.43, 0.17, 0, 0.43, 0.12, 1}, // shoulders
        {0, 0, 0.36, 0, 0, 0.02, 0.18, 1}, // trunk
        {-0.08, -0.1, 0.28, 0.08, -0.1, 0.28, 0.1, 0.8}, // chest, forward
        {-0.09, 0, -0.06, 0.09, 0, -0.06, 0.13, 1}, // hips
        {-0.31, 0, 0.42, -0.37, 0, 0.1, 0.066, 0.92}, // right arm
        {0.31, 0, 0.42, 0.37, 0, 0.1, 0.066, 0.92},
        {-0.37, 0, 0.1, -0.4, -0.05, -0.16, 0.056, 0.92},
        {0.37, 0, 0.1, 0.4, -0.05, -0.16, 0.056, 0.92},
        {-0.12, 0, -0.1, -0.13, 0, -0.5, 0.095, 0.95}, // right leg
        {0.12, 0, -0.1, 0.13, 0, -0.5, 0.095, 0.95},
        {-0.13, 0, -0.5, -0.13, 0.01, -0.9, 0.07, 0.95},
        {0.13, 0, -0.5, 0.13, 0.01, -0.9, 0.07, 0.95},
        {-0.13, 0.02, -0.95, -0.14, -0.18, -0.97, 0.05, 0.8}, // right foot
        {0.13, 0.02, -0.95, 0.14, -0.18, -0.97, 0.05, 0.8},
    };

    private static final double SHOULDER_DEPTH = 0.35;

    private OrientationFigure() {}

    /** A bar projected by the camera, in units of half the figure's height. y points up, depth towards the viewer. */
    private record Bar(Line2D axis, double width, double depth, double shade) {
        static Bar of(double[] limb, Matrix4d rotation) {
            Vector3d a = rotation.transformPosition(new Vector3d(limb[0], limb[1], limb[2]));
            Vector3d b = rotation.transformPosition(new Vector3d(limb[3], limb[4], limb[5]));
            return new Bar(new Line2D.Double(a.x, a.y, b.x, b.y), 2 * limb[6], (a.z + b.z) / 2 + limb[6] / 2, limb[7]);
        }
    }

    /**
     * Draws the figure.
     *
     * @param x centre, pixels
     * @param y centre, pixels
     * @param height height of the figure when upright, pixels
     */
    static void draw(HaloGraphics ink, Camera camera, double x, double y, double height) {
        double scale = height / 2;
        List<Bar> bars = Arrays.stream(LIMBS)
                .map(limb -> Bar.of(limb, camera.rotation()))
                .sorted(Comparator.comparingDouble(Bar::depth))
                .toList();
        Graphics2D g = (Graphics2D) ink.graphics().create();
        g.translate(x, y);
        // The halo of all bars first, then the figure.
        bars.forEach(bar -> draw(g, bar, scale, ink.toPixels(1.6), ink.halo()));
        Color edge = new Color(60, 66, 74, ink.foreground().getRed() < 128 ? 150 : 220);
        for (Bar bar : bars) {
            double near = 0.5 + 0.5 * Math.max(-1, Math.min(1, bar.depth / SHOULDER_DEPTH));
            draw(g, bar, scale, Math.max(0.5, ink.toPixels(0.7)), edge);
            draw(g, bar, scale, 0, colour(bar.shade * (0.78 + 0.22 * near)));
        }
        g.dispose();
    }

    private static void draw(Graphics2D g, Bar bar, double scale, double border, Color colour) {
        double width = scale * bar.width + 2 * border;
        double x1 = scale * bar.axis.getX1();
        double y1 = -scale * bar.axis.getY1();
        double x2 = scale * bar.axis.getX2();
        double y2 = -scale * bar.axis.getY2();
        g.setColor(colour);
        if (Math.hypot(x2 - x1, y2 - y1) < 0.01 * width) {
            g.fill(new Ellipse2D.Double(x1 - width / 2, y1 - width / 2, width, width));
        } else {
            g.setStroke(new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(new Line2D.Double(x1, y1, x2, y2));
        }
    }

    private static Color colour(double lightness) {
        double l = Math.max(0, Math.min(1, lightness));
        return new Color((int) (222 * l), (int) (206 * l), (int) (190 * l));
    }
}
