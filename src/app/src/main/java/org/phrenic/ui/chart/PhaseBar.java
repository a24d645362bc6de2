package org.phrenic.ui.chart;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.ui.widget.Theme;

/**
 * Where in the breath it is: inspiration, expiration and pause as long as they last, and a mark that moves over them. A
 * held breath fills the bar.
 */
public final class PhaseBar extends JComponent {
    private static final int HEIGHT = 30;
    private static final int ARC = 8;

    private double inspiration = 0.4;
    private double pause = 0.15;
    private double phase;
    private RespiratoryPhase label = RespiratoryPhase.PAUSE;
    private boolean threePhases = true;

    public PhaseBar() {
        setToolTipText("Where in the breath it is");
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.PROGRESS_BAR;
                }
            };
            accessibleContext.setAccessibleName("Phase of the breath");
        }
        return accessibleContext;
    }

    /**
     * Shares of the breath.
     *
     * @param isPlain whether a breath is inspiration, expiration, pause in this order; if not, the bar shows what it
     *     does alone
     */
    public void setPhaseFractions(double inspiratoryFraction, double pauseFraction, boolean isPlain) {
        inspiration = inspiratoryFraction;
        pause = pauseFraction;
        threePhases = isPlain;
        repaint();
    }

    public void setPhase(double newPhase, RespiratoryPhase newLabel) {
        phase = newPhase;
        if (label != newLabel) {
            label = newLabel;
            getAccessibleContext().setAccessibleDescription(PhaseColours.displayName(newLabel));
        }
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(200, HEIGHT);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(60, HEIGHT);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(getFont());
        int w = getWidth();
        g.clip(new RoundRectangle2D.Double(0, 0, w, getHeight(), ARC, ARC));
        if (!threePhases || label == RespiratoryPhase.HOLD) {
            paintBand(g, 0, w, label, true);
        } else {
            double in = inspiration * w;
            double out = (1 - pause) * w;
            paintBand(g, 0, in, RespiratoryPhase.INSPIRATION, label == RespiratoryPhase.INSPIRATION);
            paintBand(g, in, out, RespiratoryPhase.EXPIRATION, label == RespiratoryPhase.EXPIRATION);
            paintBand(g, out, w, RespiratoryPhase.PAUSE, label == RespiratoryPhase.PAUSE);
        }
        paintCursor(g, phase * w);
        g.dispose();
    }

    private void paintBand(Graphics2D g, double from, double to, RespiratoryPhase what, boolean now) {
        Color colour = PhaseColours.of(what);
        g.setColor(now ? colour : new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 110));
        g.fill(new Rectangle2D.Double(from, 0, to - from, getHeight()));
        String name = PhaseColours.displayName(what);
        FontMetrics metrics = g.getFontMetrics();
        if (metrics.stringWidth(name) + 8 < to - from) {
            g.setColor(now ? PhaseColours.textColour() : Theme.secondaryText());
            g.drawString(
                    name,
                    (float) ((from + to - metrics.stringWidth(name)) / 2),
                    (getHeight() + metrics.getAscent() - metrics.getDescent()) / 2f);
        }
    }

    private void paintCursor(Graphics2D g, double x) {
        g.setColor(PhaseColours.textColour());
        g.fill(new Rectangle2D.Double(x - 1, 0, 2, getHeight()));
        Path2D tip = new Path2D.Double();
        tip.moveTo(x - 5, 0);
        tip.lineTo(x + 5, 0);
        tip.lineTo(x, 6);
        tip.closePath();
        g.fill(tip);
    }
}
