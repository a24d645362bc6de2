package org.phrenic.ui.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.Icon;

/** Icons of buttons: shapes on a 16 x 16 grid, sharp at any scale, in the colour of the button's text. */
public enum Icons implements Icon {
    PLAY(0, List.of(), List.of(polygon(4, 2.5, 13.5, 8, 4, 13.5))),
    PAUSE(0, List.of(), List.of(new Rectangle2D.Double(3.5, 3, 3.2, 10), new Rectangle2D.Double(9.3, 3, 3.2, 10))),
    STEP(0, List.of(), List.of(polygon(3, 3, 10, 8, 3, 13), new Rectangle2D.Double(11, 3, 2, 10))),
    RESET(
            1.6f,
            List.of(new Arc2D.Double(3, 3.2, 10, 10, 130, -300, Arc2D.OPEN)),
            List.of(polygon(1.6, 5.8, 6.6, 6.2, 4, 1.6))),
    CAMERA(
            1.4f,
            List.of(new Rectangle2D.Double(1.7, 4.5, 12.6, 8.6), new Ellipse2D.Double(5.4, 6.2, 5.2, 5.2)),
            List.of(new Rectangle2D.Double(5.2, 2.4, 5.6, 2.4))),
    THEME(
            1.5f,
            List.of(new Ellipse2D.Double(2, 2, 12, 12)),
            List.of(new Arc2D.Double(2, 2, 12, 12, -90, 180, Arc2D.PIE))),
    MESH(1.2f, List.of(polygon(8, 2, 14.5, 13.5, 1.5, 13.5), polygon(4.75, 7.75, 11.25, 7.75, 8, 13.5)), List.of()),
    CLOSE(1.5f, List.of(new Line2D.Double(4, 4, 12, 12), new Line2D.Double(12, 4, 4, 12)), List.of());

    private static final int SIZE = 16;

    private final float lineWidth;
    private final List<Shape> outlines;
    private final List<Shape> areas;

    Icons(float lineWidth, List<Shape> outlines, List<Shape> areas) {
        this.lineWidth = lineWidth;
        this.outlines = outlines;
        this.areas = areas;
    }

    private static Path2D polygon(double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            path.lineTo(xy[i], xy[i + 1]);
        }
        path.closePath();
        return path;
    }

    @Override
    public void paintIcon(Component c, Graphics graphics, int x, int y) {
        Graphics2D g = Controls.smooth(graphics);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.translate(x, y);
        UIScale.scaleGraphics(g);
        g.setColor(c.isEnabled() ? c.getForeground() : Theme.SECONDARY_TEXT);
        g.setStroke(new BasicStroke(lineWidth, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        outlines.forEach(g::draw);
        areas.forEach(g::fill);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(SIZE);
    }

    @Override
    public int getIconHeight() {
        return UIScale.scale(SIZE);
    }
}
