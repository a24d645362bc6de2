package org.phrenic.cli.chart;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;

/**
 * Labels of points that overlap neither each other nor the points. Each label takes the first free one of the places
 * around its point, nearest first; from farther ones a line leads to the point. A label without a free place is drawn
 * at the nearest one.
 */
final class PointLabels extends AbstractXYAnnotation {
    private static final long serialVersionUID = 1;
    private static final int FONT_SIZE = 12;
    private static final Color TEXT = new Color(0x30363c);
    private static final Color LEADER = new Color(0x8a9299);
    /** Half of the square that a point takes, pixels. */
    private static final double POINT = 10;
    /** Distances of a label from its point, pixels. */
    private static final double[] DISTANCES = {13, 26, 42, 60, 80, 105, 135, 170};
    /** Distance from which a line leads to the point. */
    private static final double LEADER_FROM = 20;
    /** Directions from the point: right, left, then oblique and vertical ones. */
    private static final double[][] DIRECTIONS = {
        {1, 0}, {-1, 0}, {0.9, -0.5}, {0.9, 0.5}, {-0.9, -0.5}, {-0.9, 0.5}, {0, -1}, {0, 1}
    };

    /**
     * A point and its label.
     *
     * @param x value on the domain axis
     * @param y value on the range axis
     */
    record Label(double x, double y, String text) {}

    private final transient List<Label> labels;

    /** @param labels in the order in which they choose their places */
    PointLabels(List<Label> labels) {
        this.labels = List.copyOf(labels);
    }

    @Override
    public void draw(
            Graphics2D g,
            XYPlot plot,
            Rectangle2D area,
            ValueAxis domain,
            ValueAxis range,
            int renderer,
            PlotRenderingInfo info) {
        List<Point2D> points = new ArrayList<>();
        List<Rectangle2D> taken = new ArrayList<>();
        for (Label label : labels) {
            double x = domain.valueToJava2D(label.x, area, plot.getDomainAxisEdge());
            double y = range.valueToJava2D(label.y, area, plot.getRangeAxisEdge());
            points.add(new Point2D.Double(x, y));
            taken.add(new Rectangle2D.Double(x - POINT, y - POINT, 2 * POINT, 2 * POINT));
        }
        g.setFont(ChartStyle.font(FONT_SIZE));
        FontMetrics font = g.getFontMetrics();
        for (int i = 0; i < labels.size(); i++) {
            String text = labels.get(i).text;
            Rectangle2D place = place(points.get(i), font.stringWidth(text), font.getHeight(), area, taken);
            taken.add(place);
            drawLeader(g, points.get(i), place);
            g.setPaint(TEXT);
            g.drawString(text, (float) place.getX(), (float) (place.getY() + font.getAscent()));
        }
    }

    private static Rectangle2D place(
            Point2D point, double width, double height, Rectangle2D area, List<Rectangle2D> taken) {
        Rectangle2D first = null;
        for (double distance : DISTANCES) {
            for (double[] direction : DIRECTIONS) {
                double x = point.getX() + distance * direction[0] + 0.5 * width * (Math.signum(direction[0]) - 1);
                double y = point.getY() + distance * direction[1] - 0.5 * height;
                Rectangle2D place = new Rectangle2D.Double(x, y, width, height);
                first = first == null ? place : first;
                if (area.contains(place) && taken.stream().noneMatch(place::intersects)) {
                    return place;
                }
            }
        }
        return first;
    }

    /** Draws a line from a point to the nearest place of its label's edge, if that is far away. */
    private static void drawLeader(Graphics2D g, Point2D point, Rectangle2D place) {
        double x = Math.max(place.getMinX(), Math.min(place.getMaxX(), point.getX()));
        double y = Math.max(place.getMinY(), Math.min(place.getMaxY(), point.getY()));
        if (point.distance(x, y) > LEADER_FROM) {
            g.setPaint(LEADER);
            g.draw(new Line2D.Double(point.getX(), point.getY(), x, y));
        }
    }
}
