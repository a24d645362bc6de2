package org.phrenic.ui.access.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.mesh.Vectors;
import org.phrenic.ui.access.UltrasoundShot;
import org.phrenic.ui.widget.PaintedComponent;

/**
 * Paints a live ultrasound image with marks of depth, the probe's marker on the left, the guide line of the needle and,
 * as a help, the outline of the target. The needle itself is in the image where it is in the beam.
 */
public final class UltrasoundView extends PaintedComponent {
    private static final Color MARKS = new Color(0xb8bec4);
    private static final Color TEXT = new Color(0xd5dade);
    private static final Color MARKER = new Color(0x4f9de0);
    private static final Color GUIDE = new Color(0xffc233);
    private static final Color TARGET = new Color(0xf2e05a);
    private static final int MARGIN = 8;
    private static final int TICK = 4;
    private static final int LONG_TICK = 8;
    private static final double GUIDE_BEYOND_MM = 20;
    private static final double GUIDE_STEP_MM = 1;

    private transient Optional<UltrasoundShot> shot = Optional.empty();
    private String hint = "";
    private boolean guided = true;
    private boolean outlined = true;

    UltrasoundView() {
        super(AccessibleRole.CANVAS, "Ultrasound image");
        setName("Ultrasound image");
        setToolTipText(
                "The live image, the probe's marker on the left and the skin on top; the wheel moves the needle");
        setOpaque(true);
    }

    /** Shows an image; without one, a hint. */
    void show(Optional<UltrasoundShot> next, String why) {
        shot = next;
        hint = why;
        repaint();
    }

    /** Whether the line is shown along which the needle points. */
    void setGuided(boolean on) {
        guided = on;
        repaint();
    }

    /** Whether the target is outlined. */
    void setOutlined(boolean on) {
        outlined = on;
        repaint();
    }

    /** The image that is shown. */
    public Optional<UltrasoundShot> shot() {
        return shot;
    }

    /** What is said instead of an image. */
    String hint() {
        return hint;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(320, 320);
    }

    @Override
    protected void paintContent(Graphics2D g) {
        g.setColor(Color.BLACK);
        g.fillRect(0, 0, getWidth(), getHeight());
        if (shot.isEmpty()) {
            paintHint(g);
            return;
        }
        int side = Math.min(getWidth(), getHeight());
        double scale = (double) side / BModeImage.SIZE;
        AffineTransform place = AffineTransform.getTranslateInstance((getWidth() - side) / 2.0, 0);
        place.scale(scale, scale);
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(shot.get().picture(), place, null);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        paintMarks(g, shot.get().image(), place);
        if (outlined) {
            paintTarget(g, shot.get(), place, scale);
        }
        if (guided && shot.get().state().hasNeedle()) {
            paintGuide(g, shot.get(), place);
        }
    }

    private void paintHint(Graphics2D g) {
        g.setColor(TEXT);
        int y = MARGIN + 2 * g.getFontMetrics().getHeight();
        for (String line : hint.lines().toList()) {
            g.drawString(line, MARGIN + 4, y);
            y += g.getFontMetrics().getHeight();
        }
    }

    private void paintMarks(Graphics2D g, BModeImage image, AffineTransform place) {
        double[] face = image.pixelOf(image.pose().face());
        double perCm = 10 / image.mmPerPixel();
        int centimetres = (int) (image.settings().depthMm() / 10);
        FontMetrics metrics = g.getFontMetrics();
        double right = at(place, BModeImage.SIZE, 0)[0];
        g.setStroke(new BasicStroke(1));
        for (int cm = 0; cm <= centimetres; cm++) {
            double y = at(place, 0, face[1] + cm * perCm)[1];
            boolean five = cm % 5 == 0;
            g.setColor(MARKS);
            g.draw(new Line2D.Double(right - (five ? LONG_TICK : TICK), y, right, y));
            if (five && cm > 0) {
                String text = cm + (cm + 5 > centimetres ? " cm" : "");
                float low = (float) Math.min(y + 0.35 * metrics.getAscent(), getHeight() - 3.0);
                g.drawString(text, (float) (right - LONG_TICK - 4 - metrics.stringWidth(text)), low);
            }
        }
        double[] top = at(place, face[0] - 0.22 * BModeImage.SIZE, 0);
        g.setColor(MARKER);
        g.fill(new Ellipse2D.Double(top[0] - 4, MARGIN - 4, 8, 8));
    }

    /** The guide line: strong where the needle's line is in the beam, faint elsewhere. */
    private static void paintGuide(Graphics2D g, UltrasoundShot shot, AffineTransform place) {
        NeedleState state = shot.state();
        BModeImage image = shot.image();
        // The needle is not painted over.
        double[] entry = state.placed() ? state.tip() : state.entry().orElseThrow();
        double[] along = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        double length = Math.max(0, state.aimedDepthMm() - state.depthMm()) + GUIDE_BEYOND_MM;
        Stroke strong = new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 5}, 0);
        Stroke faint = new BasicStroke(1f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {1, 6}, 0);
        g.setColor(GUIDE);
        int steps = (int) Math.ceil(length / GUIDE_STEP_MM);
        int from = 0;
        for (int i = 0; i < steps; i++) {
            boolean here = image.isInBeam(Vectors.addScaled(entry, along, (i + 0.5) * GUIDE_STEP_MM));
            boolean next = i + 1 < steps && image.isInBeam(Vectors.addScaled(entry, along, (i + 1.5) * GUIDE_STEP_MM));
            if (here != next || i == steps - 1) {
                double[] a = at(place, image.pixelOf(Vectors.addScaled(entry, along, from * GUIDE_STEP_MM)));
                double[] b = at(place, image.pixelOf(Vectors.addScaled(entry, along, (i + 1) * GUIDE_STEP_MM)));
                g.setStroke(here ? strong : faint);
                g.draw(new Line2D.Double(a[0], a[1], b[0], b[1]));
                from = i + 1;
            }
        }
    }

    /** The circle in which the image plane cuts the target. */
    private static void paintTarget(Graphics2D g, UltrasoundShot shot, AffineTransform place, double scale) {
        double[] target = shot.state().target();
        double off = shot.image().pose().toProbe(target)[2];
        double radius = shot.state().targetRadiusMm();
        if (Math.abs(off) < radius) {
            double r = Math.sqrt(radius * radius - off * off) / shot.image().mmPerPixel() * scale;
            double[] c = at(place, shot.image().pixelOf(target));
            g.setColor(TARGET);
            g.setStroke(new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0));
            g.draw(new Ellipse2D.Double(c[0] - r, c[1] - r, 2 * r, 2 * r));
        }
    }

    private static double[] at(AffineTransform place, double... pixel) {
        double[] out = new double[2];
        place.transform(pixel, 0, out, 0, 1);
        return out;
    }
}
