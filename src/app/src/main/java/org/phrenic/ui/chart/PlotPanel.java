package org.phrenic.ui.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.util.function.DoubleConsumer;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.panel.CrosshairOverlay;
import org.jfree.chart.plot.Crosshair;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.Range;
import org.phrenic.ui.widget.Theme;

/**
 * The panel of the chart: dragging or the wheel zooms into a time range, a double click resets it, and a crosshair
 * follows the mouse.
 */
final class PlotPanel extends ChartPanel {
    private static final double ZOOM_PER_NOTCH = 1.25;
    /** Least and greatest range of times that the wheel shows, s. */
    private static final double LEAST_S = 0.1;

    private static final double MOST_S = 600;

    private final transient PlotChart plot;
    private final transient DoubleConsumer cursorListener;
    private final transient Runnable zoomListener;
    private final transient Runnable resetListener;
    private final transient Crosshair cursor = crosshair(Theme.SECONDARY_TEXT, 1);
    private final transient Crosshair marked = crosshair(Theme.ACCENT, 2);

    /**
     * @param cursorListener gets the time under the mouse, NaN outside of the plot
     * @param zoomListener runs after a time range is chosen
     * @param resetListener runs when the whole range is to be shown
     */
    PlotPanel(PlotChart plot, DoubleConsumer cursorListener, Runnable zoomListener, Runnable resetListener) {
        // Drawn at its own size, into a buffer, so that the crosshair moves without drawing the curves again.
        super(plot.chart(), 400, 200, 40, 40, 10_000, 10_000, true, false, false, false, false, false);
        this.plot = plot;
        this.cursorListener = cursorListener;
        this.zoomListener = zoomListener;
        this.resetListener = resetListener;
        setRangeZoomable(false);
        setMouseWheelEnabled(false);
        setZoomTriggerDistance(6);
        CrosshairOverlay overlay = new CrosshairOverlay();
        overlay.addDomainCrosshair(marked);
        overlay.addDomainCrosshair(cursor);
        addOverlay(overlay);
        getAccessibleContext().setAccessibleName("Plot of the chosen curves over time");
        MouseAdapter mouse = new CursorMouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    private static Crosshair crosshair(Color colour, int width) {
        return new Crosshair(Double.NaN, colour, new BasicStroke(width));
    }

    /** Marks the time of the recorded frame that is shown; NaN for none. */
    void setMarkedTime(double time) {
        marked.setValue(time);
    }

    /** Time under the mouse, s; NaN outside of the plot. */
    double cursorTime() {
        return cursor.getValue();
    }

    @Override
    public void zoom(Rectangle2D selection) {
        super.zoom(selection);
        zoomListener.run();
    }

    /** Dragging to the left asks for the whole range. The axes have no automatic range. */
    @Override
    public void restoreAutoBounds() {
        resetListener.run();
    }

    private final class CursorMouse extends MouseAdapter {
        @Override
        public void mouseMoved(MouseEvent e) {
            Rectangle2D area = getScreenDataArea();
            boolean inside = area.contains(e.getPoint());
            setCursor(inside ? plot.timeAxis().java2DToValue(e.getX(), area, RectangleEdge.BOTTOM) : Double.NaN);
        }

        @Override
        public void mouseExited(MouseEvent e) {
            setCursor(Double.NaN);
        }

        private void setCursor(double time) {
            if (Double.compare(time, cursor.getValue()) != 0) {
                cursor.setValue(time);
                cursorListener.accept(time);
            }
        }

        /** Zooms about the time under the mouse; times before the start are not shown. */
        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            Rectangle2D area = getScreenDataArea();
            if (area.contains(e.getPoint())) {
                Range shown = plot.timeAxis().getRange();
                double time = plot.timeAxis().java2DToValue(e.getX(), area, RectangleEdge.BOTTOM);
                double length = shown.getLength() * Math.pow(ZOOM_PER_NOTCH, e.getPreciseWheelRotation());
                double within = Math.max(LEAST_S, Math.min(MOST_S, length));
                double from = Math.max(0, time - (time - shown.getLowerBound()) * within / shown.getLength());
                plot.timeAxis().setRange(from, from + within);
                zoomListener.run();
            }
        }

        @Override
        public void mouseClicked(MouseEvent e) {
            if (e.getClickCount() == 2) {
                resetListener.run();
            }
        }
    }
}
