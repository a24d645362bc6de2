package org.phrenic.scene.annotate;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.phrenic.scene.camera.Camera;

/**
 * A small person who stands as the patient does, turned as the camera turns: limbs are rounded bars, drawn from the
 * farthest to the nearest; nose, palms and feet point forward.
 */
final class OrientationFigure {
    /**
     * Bars in the body's frame (x to the person's left, y back, z up; the figure is 2 high, about the origin): ends,
     * radius, tone.
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

    private OrientationFigure() {}

    /**
     * Draws it.
     *
     * @param x its middle, pixels
     * @param y its middle, pixels
     * @param height of a standing figure, pixels
     */
    static void draw(HaloGraphics ink, Camera camera, double x, double y, double height) {
        double[] right = camera.right();
        double[] up = camera.up();
        double[] towards = camera.towardsViewer();
        double scale = height / 2;
        List<double[]> bars = new ArrayList<>(List.of(LIMBS));
        bars.sort(Comparator.comparingDouble(bar -> depth(bar, towards)));
        // First the rim of all, then the figure on it.
        for (double[] bar : bars) {
            draw(ink, bar, right, up, x, y, scale, ink.toPixels(1.6), ink.halo());
        }
        for (double[] bar : bars) {
            double near = 0.5 + 0.5 * Math.max(-1, Math.min(1, depth(bar, towards) / 0.35));
            draw(ink, bar, right, up, x, y, scale, Math.max(0.5, ink.toPixels(0.7)), edge(ink));
            draw(ink, bar, right, up, x, y, scale, 0, shade(bar[7] * (0.78 + 0.22 * near)));
        }
    }

    private static double depth(double[] bar, double[] towards) {
        double depth = 0;
        for (int k = 0; k < 3; k++) {
            depth += towards[k] * (bar[k] + bar[3 + k]) / 2;
        }
        // A thick bar reaches nearer than its middle.
        return depth + bar[6] / 2;
    }

    private static void draw(
            HaloGraphics ink,
            double[] bar,
            double[] right,
            double[] up,
            double x,
            double y,
            double scale,
            double more,
            Color colour) {
        double[] from = project(bar, 0, right, up, x, y, scale);
        double[] to = project(bar, 3, right, up, x, y, scale);
        double width = 2 * bar[6] * scale + 2 * more;
        ink.graphics().setColor(colour);
        if (Math.hypot(to[0] - from[0], to[1] - from[1]) < 0.01 * width) {
            ink.graphics().fill(new Ellipse2D.Double(from[0] - width / 2, from[1] - width / 2, width, width));
        } else {
            ink.graphics().setStroke(new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            ink.graphics().draw(new Line2D.Double(from[0], from[1], to[0], to[1]));
        }
    }

    private static double[] project(
            double[] bar, int at, double[] right, double[] up, double x, double y, double scale) {
        double across = 0;
        double upward = 0;
        for (int k = 0; k < 3; k++) {
            across += right[k] * bar[at + k];
            upward += up[k] * bar[at + k];
        }
        return new double[] {x + scale * across, y - scale * upward};
    }

    private static Color edge(HaloGraphics ink) {
        return new Color(60, 66, 74, ink.foreground().getRed() < 128 ? 150 : 220);
    }

    private static Color shade(double lightness) {
        double l = Math.max(0, Math.min(1, lightness));
        return new Color((int) (222 * l), (int) (206 * l), (int) (190 * l));
    }
}
