package org.phrenic.ui.access.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
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
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.annotate.PatientOrientation;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Theme;

/** Paints a section through the body: the structures that are cut, the needle, the planned path and the target. */
public final class SectionView extends JPanel {
    private static final int MARGIN = 8;
    private static final double CROSS_ARM_MM = 6;
    private static final double NEEDLE_BEYOND_SKIN = 60;
    /** Opacity of the halo of letters, of 255. */
    private static final int HALO_ALPHA = 170;

    private static final Color TARGET = new Color(0xf2c500);
    private static final Color NEEDLE = Theme.colour(0x1f4e79, 0x9cc9f2);
    private static final Color BACKGROUND = Theme.colour(0xf2f5f7, 0x1d2226);

    private final String title;
    private final double halfWidthMm;
    private final boolean acrossNeedle;
    private transient BodySection section;
    private PathAdvice.Level level = PathAdvice.Level.FREE;
    private boolean placed;
    private String hint = "";

    /**
     * @param halfMm from the middle to the nearer edge, mm
     * @param across whether the plane is across the needle, so that needle and path are points
     */
    public SectionView(String title, double halfMm, boolean across) {
        this.title = title;
        this.halfWidthMm = halfMm;
        this.acrossNeedle = across;
        setName(title);
        getAccessibleContext().setAccessibleName(title);
        setToolTipText(
                across
                        ? "What lies at the tip, before the needle is in at the target, seen from the hub along it:"
                                + " the cross is the needle"
                        : "The plane that holds the needle, as level as possible, seen from below like an axial slice");
        setOpaque(true);
    }

    /** Shows a section, or a hint if it is null. */
    public void show(BodySection now, PathAdvice.Level marked, boolean needleIsPlaced, String why) {
        section = now;
        level = marked;
        placed = needleIsPlaced;
        hint = why;
        repaint();
    }

    public BodySection section() {
        return section;
    }

    /** What the section passes through: across a needle that is not in yet, it is the target. */
    String heading() {
        return acrossNeedle && section != null && !placed ? "At the target" : title;
    }

    /** What is said instead of a section. */
    String hint() {
        return hint;
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
        Graphics2D g = Controls.smooth(graphics);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(BACKGROUND);
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
            g.setColor(sheet ? colour : Theme.isDark() ? colour.brighter() : colour.darker());
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
        return switch (kind) {
            case SKIN, PLEURA -> Theme.withAlpha(colour, Theme.isDark() ? 46 : 60);
            case LUNG -> Theme.withAlpha(colour, 130);
            default -> Theme.withAlpha(colour, 225);
        };
    }

    private static void paintTarget(Graphics2D g, BodySection s, AffineTransform toPixels, double scale) {
        double[] at = new double[2];
        toPixels.transform(s.target(), 0, at, 0, 1);
        double cut = s.targetSectionRadiusMm() * scale;
        g.setColor(TARGET);
        g.fill(new Ellipse2D.Double(at[0] - cut, at[1] - cut, 2 * cut, 2 * cut));
        double whole = s.targetRadiusMm() * scale;
        g.setColor(Theme.TEXT);
        g.setStroke(new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0));
        g.draw(new Ellipse2D.Double(at[0] - whole, at[1] - whole, 2 * whole, 2 * whole));
    }

    private void paintNeedle(Graphics2D g, BodySection s, AffineTransform toPixels) {
        double[] p = new double[6];
        toPixels.transform(s.entry(), 0, p, 0, 1);
        toPixels.transform(s.tip(), 0, p, 2, 1);
        toPixels.transform(s.end(), 0, p, 4, 1);
        g.setColor(new Color(NeedleMarkers.rgb(level)));
        g.setStroke(new BasicStroke(2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {6, 4}, 0));
        g.draw(new Line2D.Double(p[0], p[1], p[4], p[5]));
        if (placed) {
            double share = NEEDLE_BEYOND_SKIN / Math.hypot(p[4] - p[0], p[5] - p[1]);
            g.setColor(NEEDLE);
            g.setStroke(new BasicStroke(3f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(new Line2D.Double(p[0] - share * (p[4] - p[0]), p[1] - share * (p[5] - p[1]), p[2], p[3]));
        }
    }

    private void paintCross(Graphics2D g, BodySection s, AffineTransform toPixels, double scale) {
        double[] at = new double[2];
        toPixels.transform(s.tip(), 0, at, 0, 1);
        double reach = CROSS_ARM_MM * scale;
        Path2D cross = new Path2D.Double(new Line2D.Double(at[0] - reach, at[1], at[0] + reach, at[1]));
        cross.append(new Line2D.Double(at[0], at[1] - reach, at[0], at[1] + reach), false);
        g.setStroke(new BasicStroke(4f));
        g.setColor(BACKGROUND);
        g.draw(cross);
        g.setStroke(new BasicStroke(2f));
        g.setColor(placed ? NEEDLE : new Color(NeedleMarkers.rgb(level)));
        g.draw(cross);
    }

    private void paintLabels(Graphics2D g) {
        g.setFont(getFont());
        g.setColor(Theme.TEXT);
        int height = g.getFontMetrics().getAscent();
        paintText(g, heading(), MARGIN, MARGIN + height);
        if (section == null) {
            g.setColor(Theme.SECONDARY_TEXT);
            int y = MARGIN + 3 * height;
            for (String line : hint.lines().toList()) {
                paintText(g, line, MARGIN, y);
                y += g.getFontMetrics().getHeight();
            }
            return;
        }
        g.setFont(getFont().deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        int middle = (getHeight() + height) / 2;
        EdgeLetters letters = EdgeLetters.of(section.right(), section.up());
        paintText(g, letters.right(), getWidth() - MARGIN - metrics.stringWidth(letters.right()), middle);
        paintText(g, letters.left(), MARGIN, middle);
        paintText(g, letters.top(), (getWidth() - metrics.stringWidth(letters.top())) / 2, MARGIN + 2 * height + 2);
        int bottom = (getWidth() - metrics.stringWidth(letters.bottom())) / 2;
        paintText(g, letters.bottom(), bottom, getHeight() - MARGIN);
        paintScaleBar(g);
    }

    /** Text with a halo of the background. */
    private static void paintText(Graphics2D g, String words, int x, int y) {
        paintText(g, BACKGROUND, words, x, y);
    }

    /** Text with a halo of the colour that lies behind it, or of another one that it can be read on. */
    static void paintText(Graphics2D g, Color behind, String words, int x, int y) {
        Color ink = g.getColor();
        g.setColor(Theme.withAlpha(behind, HALO_ALPHA));
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
        Line2D bar = new Line2D.Double(x, y, x + w, y);
        g.setColor(Theme.withAlpha(BACKGROUND, HALO_ALPHA));
        g.setStroke(new BasicStroke(4.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(bar);
        g.setColor(Theme.TEXT);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(bar);
        String text = (int) mm + " mm";
        paintText(g, text, x + w - g.getFontMetrics().stringWidth(text), y - 4);
    }

    /** Directions of the patient at the edges of a section. */
    record EdgeLetters(String left, String right, String top, String bottom) {
        /** Letters of all edges from those at the right and at the top. */
        static EdgeLetters of(String right, String top) {
            return new EdgeLetters(PatientOrientation.opposite(right), right, top, PatientOrientation.opposite(top));
        }
    }
}
