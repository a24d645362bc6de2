package org.phrenic.cli.chart;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.axis.TickType;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;
import org.phrenic.file.Numbers;

/** A logarithmic axis with labels at 1, 2 and 5 times each power of ten, or only at the powers over a wide range. */
final class DecadeAxis extends LogAxis {
    private static final long serialVersionUID = 1;
    private static final double MANY_DECADES = 3.5;
    private static final double SLACK = 1 + 1e-9;

    DecadeAxis(String label, double low, double high) {
        super(label);
        ChartStyle.axis(this);
        setAutoRange(false);
        setRange(low, high);
    }

    @Override
    protected List<NumberTick> refreshTicksHorizontal(Graphics2D g2, Rectangle2D area, RectangleEdge edge) {
        return ticks(TextAnchor.TOP_CENTER);
    }

    @Override
    protected List<NumberTick> refreshTicksVertical(Graphics2D g2, Rectangle2D area, RectangleEdge edge) {
        return ticks(TextAnchor.CENTER_RIGHT);
    }

    private List<NumberTick> ticks(TextAnchor anchor) {
        List<NumberTick> ticks = new ArrayList<>();
        double low = getRange().getLowerBound();
        double high = getRange().getUpperBound();
        boolean many = Math.log10(high / low) > MANY_DECADES;
        for (int decade = (int) Math.floor(Math.log10(low)); decade <= Math.log10(high); decade++) {
            for (int digit = 1; digit < 10; digit++) {
                double value = digit * Math.pow(10, decade);
                if (value >= low / SLACK && value <= high * SLACK) {
                    boolean named = digit == 1 || (!many && (digit == 2 || digit == 5));
                    TickType type = named ? TickType.MAJOR : TickType.MINOR;
                    ticks.add(new NumberTick(type, value, named ? name(value) : "", anchor, TextAnchor.CENTER, 0));
                }
            }
        }
        return ticks;
    }

    private static String name(double value) {
        int digits = Math.max(0, (int) -Math.floor(Math.log10(value * SLACK)));
        return Numbers.format("%." + digits + "f", value);
    }
}
