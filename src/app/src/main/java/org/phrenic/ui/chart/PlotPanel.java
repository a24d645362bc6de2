package org.phrenic.ui.chart;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.function.Consumer;
import javax.swing.UIManager;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.panel.AbstractOverlay;
import org.jfree.chart.panel.Overlay;
import org.jfree.chart.ui.RectangleEdge;
import org.phrenic.ui.widget.Theme;

/**
 * The chart on the screen: dragging zooms into times, a double click shows all again, and a line follows the mouse
 * whose time others are told.
 */
final class PlotPanel extends ChartPanel {
    private final transient PlotChart plot;
    private final transient Consumer<Double> cursorListener;
    private final transient Runnable zoomListener;
    private final transient Runnable resetListener;
    private double cursorTime = Double.NaN;
    private double markedTime = Double.NaN;

    /**
     * @param cursor told the time under the mouse, NaN when it has left
     * @param zoomed told when the user has chosen the times to be seen
     * @param reset told when all is to be seen again
     */
    PlotPanel(PlotChart plot, Consumer<Double> cursor, Runnable zoomed, Runnable reset) {
        // Drawn at the size it has, whatever that is; into a buffer, so that the cursor moves without drawing the
        // curves again.
        super(plot.chart(), 400, 200, 40, 40, 10_000, 10_000, true, false, false, false, false, false);
        this.plot = plot;
        this.cursorListener = cursor;
        this.zoomListener = zoomed;
        this.resetListener = reset;
        setRangeZoomable(false);
        setMouseWheelEnabled(false);
        setZoomTriggerDistance(6);
        addOverlay(new CursorOverlay());
        getAccessibleContext().setAccessibleName("Plot of the chosen curves over time");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                Rectangle2D area = getScreenDataArea();
                setCursorTime(
                        area.contains(e.getPoint())
                                ? plot.timeAxis().java2DToValue(e.getX(), area, RectangleEdge.BOTTOM)
                                : Double.NaN);
            }

            @Override
            public void mouseExited(MouseEvent e) {
                setCursorTime(Double.NaN);
            }

            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    reset.run();
                }
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    private void setCursorTime(double time) {
        if (Double.compare(time, cursorTime) != 0) {
            cursorTime = time;
            cursorListener.accept(time);
            repaint();
        }
    }

    /** Marks the time of the recorded frame that is looked at; NaN for none. */
    void setMarkedTime(double time) {
        if (Double.compare(time, markedTime) != 0) {
            markedTime = time;
            repaint();
        }
    }

    /** Time under the mouse, s; NaN if it is elsewhere. */
    double cursorTime() {
        return cursorTime;
    }

    @Override
    public void zoom(Rectangle2D selection) {
        super.zoom(selection);
        if (zoomListener != null) {
            zoomListener.run();
        }
    }

    @Override
    public void restoreAutoBounds() {
        // Dragging to the left means "all of it again"; the axes have no automatic range of their own.
        if (resetListener != null) {
            resetListener.run();
        }
    }

    private final class CursorOverlay extends AbstractOverlay implements Overlay {
        @Override
        public void paintOverlay(Graphics2D g, ChartPanel panel) {
            Color text = UIManager.getColor("Label.foreground");
            line(g, markedTime, Theme.ACCENT, 2);
            line(g, cursorTime, new Color(text.getRed(), text.getGreen(), text.getBlue(), 150), 1);
        }

        private void line(Graphics2D g, double time, Color colour, int width) {
            if (!Double.isNaN(time) && plot.timeAxis().getRange().contains(time)) {
                Rectangle2D area = getScreenDataArea();
                int x = (int) Math.round(plot.timeAxis().valueToJava2D(time, area, RectangleEdge.BOTTOM));
                g.setColor(colour);
                g.fillRect(x - width / 2, (int) area.getMinY(), width, (int) area.getHeight());
            }
        }
    }
}
