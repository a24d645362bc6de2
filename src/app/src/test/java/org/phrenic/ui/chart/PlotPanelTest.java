package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.Range;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** The wheel over the plot shows a shorter time about the mouse, and no time before the start. */
class PlotPanelTest {
    /** Well left of the middle. */
    private static final int X = 150;
    /** Limits of the zoom, s: a fortieth of a quiet breath of 4 s, and 150 of them. */
    private static final double LEAST_S = 0.1;

    private static final double MOST_S = 600;

    /** Time under the mouse, s. */
    private static double timeAtMouse(PlotPanel panel, PlotChart chart) {
        return chart.timeAxis().java2DToValue(X, panel.getScreenDataArea(), RectangleEdge.BOTTOM);
    }

    private static Range turn(PlotPanel panel, PlotChart chart, int notches) {
        panel.dispatchEvent(new MouseWheelEvent(
                panel,
                MouseWheelEvent.MOUSE_WHEEL,
                0,
                0,
                X,
                60,
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                1,
                notches));
        return chart.timeAxis().getRange();
    }

    /** As the timeline, the view and the status line write it. */
    @Test
    void timesAreWrittenWithoutAComma() {
        EventThread.run(() -> {
            NumberAxis time = (NumberAxis) new PlotChart().timeAxis();
            assertThat(time.getNumberFormatOverride().format(1020)).isEqualTo("1020");
            assertThat(time.getNumberFormatOverride().format(1020.25)).isEqualTo("1020.25");
        });
    }

    @Test
    void theWheelZoomsAboutTheMouse() {
        EventThread.run(() -> {
            Theme.install(false);
            PlotChart chart = new PlotChart();
            chart.setCurves(PlotCurve.ofObservables().subList(0, 1));
            chart.timeAxis().setRange(10, 20);
            int[] zooms = new int[1];
            PlotPanel panel = new PlotPanel(chart, time -> {}, () -> zooms[0]++, () -> {});
            panel.setSize(600, 200);
            Graphics2D g = new BufferedImage(600, 200, BufferedImage.TYPE_INT_RGB).createGraphics();
            panel.paint(g);
            g.dispose();
            double time = timeAtMouse(panel, chart);
            Range closer = turn(panel, chart, -3);
            assertThat(closer.getLength()).isCloseTo(10 / Math.pow(1.25, 3), within(1e-9));
            assertThat(closer.getLowerBound()).isGreaterThan(10);
            assertThat(closer.getUpperBound()).isLessThan(20);
            assertThat(timeAtMouse(panel, chart)).isCloseTo(time, within(1e-9));
            assertThat(zooms[0]).isEqualTo(1);
            assertThat(turn(panel, chart, 20).getLowerBound()).isZero();
            assertThat(turn(panel, chart, -60).getLength()).isCloseTo(LEAST_S, within(1e-9));
            assertThat(turn(panel, chart, 200).getLength()).isCloseTo(MOST_S, within(1e-9));
        });
    }
}
