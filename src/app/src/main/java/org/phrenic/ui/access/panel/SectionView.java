package org.phrenic.ui.access.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.JPanel;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.BodySection;

/** A section through the body, painted: what the plane cuts, the needle, the way ahead and the target. */
public final class SectionView extends JPanel {
    private static final int MARGIN = 8;
    private static final double CROSS_ARM_MM = 6;
    private static final int TARGET = 0xf2c500;

    private final String title;
    private final double halfWidthMm;
    private final boolean acrossNeedle;
    private transient BodySection section;
    private PathAdvice.Level level = PathAdvice.Level.FREE;
    private boolean placed;
    private String hint = "";

    /**
     * @param title what is shown
     * @param halfMm from the middle to the nearer edge, mm
     * @param across whether the plane stands across the needle, so that needle and way are points
     */
    public SectionView(String title, double halfMm, boolean across) {
        this.title = title;
        this.halfWidthMm = halfMm;
        this.acrossNeedle = across;
        setName(title);
        getAccessibleContext().setAccessibleName(title);
        setToolTipText(
                across
                        ? "What lies at the tip, seen from the hub along the needle: the cross is the needle"
                        : "The plane that holds the needle, as level as it can be, seen from below as an axial slice is");
        setOpaque(true);
    }

    /** Shows a section; null for none, and why. */
    public void show(BodySection now, PathAdvice.Level marked, boolean needleIsPlaced, String why) {
        section = now;
        level = marked;
        placed = needleIsPlaced;
        hint = why;
        repaint();
    }

    /** What is shown; null for nothing. */
    public BodySection section() {
        return section;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(280, 280);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(120, 120);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(AdviceColours.viewBackground());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (section != null) {
            paint(g, section);
        }
        paintLabels(g);
        g.dispose();
    }

    private void paint(Graphics2D g, BodySection s) {
        double scale = Math.min(getWidth(), getHeight()) / (2 * halfWidthMm);
        AffineTransform toPixels = new AffineTransform(scale, 0, 0, -scale, getWidth() / 2.0, getHeight() / 2.0);
        for (BodySection.Part part : s.parts()) {
            Shape shape = toPixels.createTransformedShape(part.outline());
            Color colour = new Color(part.rgb());
            boolean sheet = part.kind() == StructureKind.DIAPHRAGM;
            if (!sheet) {
                g.setColor(fillColour(part.kind(), colour));
                g.fill(shape);
            }
            g.setColor(sheet ? colour : outlineColour(colour));
            g.setStroke(new BasicStroke(sheet ? 2f : 1f));
            g.draw(shape);
        }
        paintTarget(g, s, toPixels, scale);
        if (acrossNeedle) {
            paintCross(g, s, toPixels, scale);
        } else {
            paintNeedle(g, s, toPixels);
        }
    }

    private static Color fillColour(StructureKind kind, Color colour) {
        int alpha =
                switch (kind) {
                    case SKIN -> AdviceColours.isDark() ? 46 : 60;
                    case LUNG -> 130;
                    default -> 225;
                };
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
    }

    private static Color outlineColour(Color colour) {
        return AdviceColours.isDark() ? colour.brighter() : colour.darker();
    }

    private static void paintTarget(Graphics2D g, BodySection s, AffineTransform toPixels, double scale) {
        double[] at = new double[2];
        toPixels.transform(s.target(), 0, at, 0, 1);
        double cut = s.targetSectionRadiusMm() * scale;
        g.setColor(new Color(TARGET));
        g.fill(new Ellipse2D.Double(at[0] - cut, at[1] - cut, 2 * cut, 2 * cut));
        double whole = s.targetRadiusMm() * scale;
        g.setColor(AdviceColours.textColour());
        g.setStroke(new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0));
        g.draw(new Ellipse2D.Double(at[0] - whole, at[1] - whole, 2 * whole, 2 * whole));
    }

    private void paintNeedle(Graphics2D g, BodySection s, AffineTransform toPixels) {
        double[] p = new double[6];
        toPixels.transform(s.entry(), 0, p, 0, 1);
        toPixels.transform(s.tip(), 0, p, 2, 1);
        toPixels.transform(s.end(), 0, p, 4, 1);
        g.setColor(AdviceColours.pathColour(level));
        g.setStroke(new BasicStroke(2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {6, 4}, 0));
        g.draw(new Line2D.Double(p[0], p[1], p[4], p[5]));
        if (placed) {
            double beyond = 60;
            double length = Math.hypot(p[4] - p[0], p[5] - p[1]);
            double hx = p[0] - beyond * (p[4] - p[0]) / length;
            double hy = p[1] - beyond * (p[5] - p[1]) / length;
            g.setColor(AdviceColours.isDark() ? new Color(0x9cc9f2) : new Color(0x1f4e79));
            g.setStroke(new BasicStroke(3f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(new Line2D.Double(hx, hy, p[2], p[3]));
        }
    }

    private void paintCross(Graphics2D g, BodySection s, AffineTransform toPixels, double scale) {
        double[] at = new double[2];
        toPixels.transform(s.tip(), 0, at, 0, 1);
        double reach = CROSS_ARM_MM * scale;
        Path2D cross = new Path2D.Double();
        cross.moveTo(at[0] - reach, at[1]);
        cross.lineTo(at[0] + reach, at[1]);
        cross.moveTo(at[0], at[1] - reach);
        cross.lineTo(at[0], at[1] + reach);
        g.setStroke(new BasicStroke(4f));
        g.setColor(AdviceColours.viewBackground());
        g.draw(cross);
        g.setStroke(new BasicStroke(2f));
        g.setColor(
                placed
                        ? (AdviceColours.isDark() ? new Color(0x9cc9f2) : new Color(0x1f4e79))
                        : AdviceColours.pathColour(level));
        g.draw(cross);
    }

    private void paintLabels(Graphics2D g) {
        g.setFont(getFont());
        g.setColor(AdviceColours.textColour());
        int height = g.getFontMetrics().getAscent();
        paintText(g, title, MARGIN, MARGIN + height);
        if (section == null) {
            g.setColor(AdviceColours.secondaryText());
            int y = MARGIN + 3 * height;
            for (String line : hint.lines().toList()) {
                paintText(g, line, MARGIN, y);
                y += g.getFontMetrics().getHeight();
            }
            return;
        }
        g.setFont(getFont().deriveFont(java.awt.Font.BOLD));
        int middle = (getHeight() + height) / 2;
        paintText(g, section.right(), getWidth() - MARGIN - g.getFontMetrics().stringWidth(section.right()), middle);
        String left = opposite(section.right());
        paintText(g, left, MARGIN, middle);
        String up = section.up();
        paintText(g, up, (getWidth() - g.getFontMetrics().stringWidth(up)) / 2, MARGIN + 2 * height + 2);
        String down = opposite(up);
        paintText(g, down, (getWidth() - g.getFontMetrics().stringWidth(down)) / 2, getHeight() - MARGIN);
        paintScaleBar(g);
    }

    /** Text that can be read on whatever lies behind it. */
    private static void paintText(Graphics2D g, String words, int x, int y) {
        Color ink = g.getColor();
        Color behind = AdviceColours.viewBackground();
        g.setColor(new Color(behind.getRed(), behind.getGreen(), behind.getBlue(), 170));
        Shape outline =
                g.getFont().createGlyphVector(g.getFontRenderContext(), words).getOutline(x, y);
        g.setStroke(new BasicStroke(3f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(outline);
        g.setColor(ink);
        g.drawString(words, x, y);
    }

    private void paintScaleBar(Graphics2D g) {
        double scale = Math.min(getWidth(), getHeight()) / (2 * halfWidthMm);
        double mm = acrossNeedle ? 10 : 50;
        int w = (int) Math.round(mm * scale);
        int y = getHeight() - MARGIN - 2;
        int x = getWidth() - MARGIN - w;
        g.setFont(getFont());
        g.setColor(AdviceColours.textColour());
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Line2D.Double(x, y, x + w, y));
        String text = (int) mm + " mm";
        paintText(g, text, x + w - g.getFontMetrics().stringWidth(text), y - 4);
    }

    private static String opposite(String letters) {
        StringBuilder other = new StringBuilder();
        letters.chars()
                .forEach(c -> other.append(
                        switch (c) {
                            case 'L' -> 'R';
                            case 'R' -> 'L';
                            case 'A' -> 'P';
                            case 'P' -> 'A';
                            case 'S' -> 'I';
                            default -> 'S';
                        }));
        return other.toString();
    }
}
