package org.phrenic.ui.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.phrenic.file.Numbers;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.PaintedComponent;
import org.phrenic.ui.widget.Theme;

/**
 * The recorded time with bands of the respiratory phases and a cursor to drag. Arrow keys go one frame, page keys ten,
 * Home to the first; End follows the present.
 */
final class TimelineBar extends PaintedComponent {
    private static final int BAND_HEIGHT = 22;
    private static final int SIDE_MARGIN = 10;
    private static final double[] TICK_STEPS_S = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 60};
    private static final int MIN_TICK_PIXELS = 64;

    private final transient DoubleConsumer seekListener;
    private final transient IntConsumer stepListener;
    private transient List<PhaseBands.Band> bands = List.of();
    private double from;
    private double to = 1;
    private double markTime = Double.NaN;

    /**
     * @param seekListener gets the time that is dragged to
     * @param stepListener gets the number of frames to go; {@link Integer#MAX_VALUE} for the present
     */
    TimelineBar(DoubleConsumer seekListener, IntConsumer stepListener) {
        super(AccessibleRole.SLIDER, "Recorded time");
        this.seekListener = seekListener;
        this.stepListener = stepListener;
        setFocusable(true);
        setToolTipText("Drag through what is recorded; arrow keys go one frame");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                seek(e.getX());
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                seek(e.getX());
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        bind("LEFT", -1);
        bind("RIGHT", 1);
        bind("PAGE_UP", -10);
        bind("PAGE_DOWN", 10);
        bind("HOME", -Integer.MAX_VALUE);
        bind("END", Integer.MAX_VALUE);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                repaint();
            }

            @Override
            public void focusLost(FocusEvent e) {
                repaint();
            }
        });
    }

    private void bind(String key, int frames) {
        registerKeyboardAction(e -> stepListener.accept(frames), KeyStroke.getKeyStroke(key), WHEN_FOCUSED);
    }

    private void seek(int x) {
        double share = (x - SIDE_MARGIN) / (double) Math.max(1, getWidth() - 2 * SIDE_MARGIN);
        seekListener.accept(from + Math.max(0, Math.min(1, share)) * (to - from));
    }

    /** Sets the recorded interval, the time of the cursor (NaN for none) and the phases. */
    void setTimeline(double newFrom, double newTo, double newMark, List<PhaseBands.Band> newBands) {
        from = newFrom;
        to = Math.max(newTo, newFrom + 1e-3);
        markTime = newMark;
        bands = newBands;
        Controls.tellValue(this, Double.isNaN(newMark) ? "" : Numbers.format("%.2f s", newMark));
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(300, BAND_HEIGHT + 8 + getFontMetrics(getFont()).getHeight());
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(80, getPreferredSize().height);
    }

    @Override
    protected void paintContent(Graphics2D g) {
        RoundRectangle2D strip =
                new RoundRectangle2D.Double(SIDE_MARGIN, 2, getWidth() - 2.0 * SIDE_MARGIN, BAND_HEIGHT, 6, 6);
        Graphics2D inside = (Graphics2D) g.create();
        inside.setColor(Theme.BORDER);
        inside.clip(strip);
        inside.fill(strip);
        bands.forEach(band -> paintBand(inside, band));
        inside.dispose();
        paintTicks(g);
        if (!Double.isNaN(markTime)) {
            paintMark(g);
        }
    }

    private void paintBand(Graphics2D g, PhaseBands.Band band) {
        double x = x(band.from());
        Rectangle2D area = new Rectangle2D.Double(x, 2, x(band.to()) - x + 0.5, BAND_HEIGHT);
        PhaseColours.paintBand(g, area, band.label(), true);
    }

    private void paintTicks(Graphics2D g) {
        double step = TICK_STEPS_S[TICK_STEPS_S.length - 1];
        for (int i = TICK_STEPS_S.length - 1; i >= 0; i--) {
            if (x(from + TICK_STEPS_S[i]) - x(from) >= MIN_TICK_PIXELS) {
                step = TICK_STEPS_S[i];
            }
        }
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(Theme.SECONDARY_TEXT);
        for (long k = (long) Math.ceil(from / step); k * step <= to; k++) {
            double x = x(k * step);
            g.fill(new Rectangle2D.Double(x - 0.5, BAND_HEIGHT + 3, 1, 4));
            String text = NumberFormats.format(k * step) + " s";
            float at = (float)
                    Math.max(0, Math.min(getWidth() - metrics.stringWidth(text), x - metrics.stringWidth(text) / 2.0));
            g.drawString(text, at, BAND_HEIGHT + 7 + metrics.getAscent());
        }
    }

    private void paintMark(Graphics2D g) {
        double x = x(Math.max(from, Math.min(to, markTime)));
        g.setColor(PhaseColours.TEXT);
        g.fill(new Rectangle2D.Double(x - 1, 0, 2, BAND_HEIGHT + 4));
        Ellipse2D knob = new Ellipse2D.Double(x - 6, BAND_HEIGHT / 2.0 - 4, 12, 12);
        g.setColor(Theme.ACCENT);
        g.fill(knob);
        Color ring = isFocusOwner() ? UIManager.getColor("Component.focusedBorderColor") : null;
        g.setColor(ring == null ? PhaseColours.TEXT : ring);
        g.setStroke(new BasicStroke(isFocusOwner() ? 3 : 1.5f));
        g.draw(knob);
    }

    private double x(double time) {
        return SIDE_MARGIN + (time - from) / (to - from) * (getWidth() - 2 * SIDE_MARGIN);
    }
}
