package org.phrenic.scene.annotate;

import java.awt.geom.Path2D;
import java.util.stream.DoubleStream;
import org.phrenic.file.Numbers;

/** A scale bar with a round length in millimetres, for parallel projection. */
final class Ruler {
    private static final double[] ROUND_LENGTHS_MM = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};
    private static final double TEXT_SIZE = 11.5;

    private Ruler() {}

    /** The longest round length that fits into {@code pixels}, mm; 0 if none fits. */
    static double roundLength(double mmPerPixel, double pixels) {
        double room = pixels * mmPerPixel;
        return DoubleStream.of(ROUND_LENGTHS_MM).filter(mm -> mm <= room).max().orElse(0);
    }

    /**
     * Draws the scale bar.
     *
     * @param left left end, pixels
     * @param bottom lower edge, pixels
     * @param most maximum width, pixels
     */
    static void draw(HaloGraphics ink, double mmPerPixel, double left, double bottom, double most) {
        double length = roundLength(mmPerPixel, most);
        if (length == 0) {
            return;
        }
        double width = length / mmPerPixel;
        double tick = ink.toPixels(5);
        Path2D path = new Path2D.Double();
        path.moveTo(left, bottom - tick);
        path.lineTo(left, bottom);
        path.lineTo(left + width, bottom);
        path.lineTo(left + width, bottom - tick);
        path.moveTo(left + width / 2, bottom - tick * 0.6);
        path.lineTo(left + width / 2, bottom);
        ink.drawLine(path, Math.max(1, ink.toPixels(1.4)));
        String text = Numbers.format("%.0f mm", length);
        ink.drawText(text, left + width / 2, bottom - ink.toPixels(9), 0.5, TEXT_SIZE, false);
    }
}
