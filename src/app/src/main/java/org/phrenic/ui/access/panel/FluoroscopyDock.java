package org.phrenic.ui.access.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.joml.Vector3d;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.plan.Aids;
import org.phrenic.file.Numbers;
import org.phrenic.scene.annotate.PatientOrientation;
import org.phrenic.ui.access.FluoroscopyShot;
import org.phrenic.ui.access.GuidanceSettings;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.PaintedComponent;

/** The X-ray view: pictures of a C-arm about the target, and its angles. */
public final class FluoroscopyDock extends AccessPanel {
    private static final int MOST_OBLIQUE_DEG = 90;
    private static final int MOST_CRANIAL_DEG = 45;

    private final View view = new View();
    private final JToggleButton beam =
            toggle("X-ray on", "X-ray on", "Takes pictures, at most three a second, while it is on", this::switchBeam);
    private final JSlider oblique = Controls.describe(
            Controls.slider(-MOST_OBLIQUE_DEG, MOST_OBLIQUE_DEG, 0),
            "C-arm to the left",
            "Turns the detector toward the patient's left (LAO) or right (RAO), degrees; 0 is frontal");
    private final JSlider cranial = Controls.describe(
            Controls.slider(-MOST_CRANIAL_DEG, MOST_CRANIAL_DEG, 0),
            "C-arm to the head",
            "Turns the detector toward the head (cranial) or the feet (caudal), degrees");
    private final JLabel obliqueText = new JLabel();
    private final JLabel cranialText = new JLabel();

    public FluoroscopyDock(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        setName("x-ray");
        setLayout(new MigLayout(
                "insets 0 0 6 0, gap 6 4, fill, hidemode 3, wrap 1", "[grow, fill, 0::]", "[grow, fill][]"));
        JPanel controls = new JPanel(new MigLayout("insets 0 8 0 8, gap 6 4, wrap 2", "[grow, fill, 0::][90!]"));
        controls.add(beam, "span, growx");
        controls.add(oblique, "wmin 0");
        controls.add(obliqueText);
        controls.add(cranial, "wmin 0");
        controls.add(cranialText);
        oblique.addChangeListener(e -> turn());
        cranial.addChangeListener(e -> turn());
        turn();
        add(view, "hmin 120, grow");
        add(controls, "wmin 0");
        follow(session);
    }

    private void switchBeam() {
        rehearsal.pictures().setXrayOn(beam.isSelected());
        showHint();
        resume();
    }

    private boolean takesPictures() {
        return rehearsal.stage() == RehearsalStage.READY || rehearsal.stage() == RehearsalStage.PLAYING;
    }

    /** Says what to do, or to wait for, for a picture. */
    private void showHint() {
        view.hint = beam.isSelected() ? awaited() : "Press X-ray on for pictures.";
        view.repaint();
    }

    /** What a picture waits for; nothing where none comes. */
    private String awaited() {
        return switch (rehearsal.stage()) {
            case READY, PLAYING -> "A picture comes with the next step.";
            case LOADING, RECORDING_BREATH, MAPPING -> "Pictures come once the free paths are computed.";
            case CLOSED, UNAVAILABLE -> "";
        };
    }

    /** No picture would come of a simulation that is paused. */
    private void resume() {
        if (beam.isSelected()) {
            rehearsal.needle().resumeForPictures();
        }
    }

    private void turn() {
        rehearsal.pictures().setArmAngles(new GuidanceSettings.ArmAngles(oblique.getValue(), cranial.getValue()));
        obliqueText.setText(
                Numbers.format("%s %d\u00b0", oblique.getValue() < 0 ? "RAO" : "LAO", Math.abs(oblique.getValue())));
        cranialText.setText(Numbers.format(
                "%s %d\u00b0", cranial.getValue() < 0 ? "caudal" : "cranial", Math.abs(cranial.getValue())));
        Controls.tellValue(oblique, obliqueText.getText());
        Controls.tellValue(cranial, cranialText.getText());
        resume();
    }

    /** The picture that is shown. */
    Optional<FluoroscopyShot> shot() {
        return view.shot;
    }

    /** What is said instead of a picture. */
    String hint() {
        return view.hint;
    }

    @Override
    public void onState() {
        if (!takesPictures()) {
            view.shot = Optional.empty();
        }
        view.outlined = rehearsal.pictures().aids() != Aids.PICTURES;
        showHint();
    }

    @Override
    public void onAttemptStarted() {
        view.shot = Optional.empty();
        view.repaint();
    }

    @Override
    public void onFluoroscopy(FluoroscopyShot shot) {
        view.shot = Optional.of(shot);
        view.repaint();
    }

    /** Paints the picture and, as a help, the outline of the target. */
    private static final class View extends PaintedComponent {
        private static final Color TARGET = new Color(0xf2e05a);
        private static final Color TEXT = new Color(0xd5dade);
        /** A radiograph is dark in a light window too. */
        private static final Color BEHIND = Color.BLACK;

        private static final int MARGIN = 8;

        private transient Optional<FluoroscopyShot> shot = Optional.empty();
        private String hint = "";
        private boolean outlined = true;

        View() {
            super(AccessibleRole.CANVAS, "X-ray picture");
            setName("X-ray picture");
            setToolTipText("The picture of a C-arm about the target: bones and the needle are bright");
            setOpaque(true);
        }

        /** Directions of the patient at the edges of the picture. */
        private static void drawLetters(Graphics2D g, CArm arm, double left, double scale) {
            String right = PatientOrientation.letters(new Vector3d(arm.right()));
            String top = PatientOrientation.letters(new Vector3d(arm.up()));
            int begin = (int) Math.round(left);
            int width = (int) Math.round(scale * arm.columns());
            int middle = (int) Math.round(scale * arm.rows() / 2);
            FontMetrics metrics = g.getFontMetrics();
            SectionView.paintText(g, BEHIND, PatientOrientation.opposite(right), begin + MARGIN, middle);
            SectionView.paintText(g, BEHIND, right, begin + width - MARGIN - metrics.stringWidth(right), middle);
            SectionView.paintText(
                    g, BEHIND, top, begin + (width - metrics.stringWidth(top)) / 2, MARGIN + metrics.getAscent());
        }

        @Override
        protected void paintContent(Graphics2D g) {
            g.setColor(BEHIND);
            g.fillRect(0, 0, getWidth(), getHeight());
            g.setColor(TEXT);
            if (shot.isEmpty()) {
                g.drawString(hint, MARGIN + 4, 2 * g.getFontMetrics().getHeight());
                return;
            }
            CArm arm = shot.get().arm();
            double scale = (double) Math.min(getWidth(), getHeight()) / arm.columns();
            double left = (getWidth() - scale * arm.columns()) / 2;
            AffineTransform place = new AffineTransform(scale, 0, 0, scale, left, 0);
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            g.drawImage(shot.get().picture(), place, null);
            drawLetters(g, arm, left, scale);
            if (outlined) {
                double[] target = shot.get().state().target();
                double[] p = arm.project(target[0], target[1], target[2]);
                double r = shot.get().state().targetRadiusMm() * arm.sourceDetectorMm() / p[2] / arm.pixelMm();
                Ellipse2D circle = new Ellipse2D.Double(p[0] + 0.5 - r, p[1] + 0.5 - r, 2 * r, 2 * r);
                g.setColor(TARGET);
                g.setStroke(
                        new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0));
                g.draw(place.createTransformedShape(circle));
            }
        }
    }
}
