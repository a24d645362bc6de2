package org.phrenic.ui.access.panel;

import java.util.Optional;
import java.util.function.DoubleConsumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.GuidanceSettings;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.ProbeController;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.UltrasoundShot;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/** The live ultrasound image, the probe's angles, and the controls of the scanner. */
public final class UltrasoundDock extends AccessPanel {
    private static final String NO_PROBE = "Put the probe on the skin:\npress U, then click on the body.";
    private static final double STEP_DEG = 5;

    private final UltrasoundView view = new UltrasoundView();
    private final transient ProbeController probe = rehearsal.probe();
    private final JLabel seen = Controls.secondaryLabel(" ");
    private final JLabel angles = Controls.secondaryLabel(" ");
    private final JToggleButton put = toggle(
            "Put probe",
            "Put probe",
            "Then click on the skin (U); drag the probe to slide it, with the right button to tilt and rock it",
            () -> rehearsal.pickMode().toggle(PickMode.Kind.PROBE));
    private final JButton lift = button("Lift", "Take the probe off the skin (Shift+U)", probe::lift);
    private final JButton beside = button(
            "Needle in plane",
            "Entry beside the probe on the marker's side, the needle in the image plane at 45 degrees (K)",
            probe::enterBeside);
    private final JToggleButton guide =
            toggle("Guide line", "Guide line", "The line along which the needle points", this::showGuide);
    private final JButton turnLeft =
            button("\u21ba", "Rotate the probe anticlockwise by 5 degrees (comma)", () -> probe.turn(STEP_DEG, 0, 0));
    private final JButton turnRight =
            button("\u21bb", "Rotate the probe clockwise by 5 degrees (full stop)", () -> probe.turn(-STEP_DEG, 0, 0));

    public UltrasoundDock(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        setName("ultrasound");
        setLayout(new MigLayout(
                "insets 0 0 6 0, gap 6 4, fill, hidemode 3, wrap 1", "[grow, fill, 0::]", "[grow, fill][]"));
        guide.setSelected(true);
        turnLeft.setName("Rotate anticlockwise");
        turnLeft.getAccessibleContext().setAccessibleName("Rotate anticlockwise");
        turnRight.setName("Rotate clockwise");
        turnRight.getAccessibleContext().setAccessibleName("Rotate clockwise");
        view.addMouseWheelListener(e -> rehearsal.needle().wheelTurned(e));
        JPanel controls =
                new JPanel(new MigLayout("insets 0 8 0 8, gap 6 4, wrap 3", "[][grow, fill, 0::][right, 80!]"));
        controls.add(row(put, lift, turnLeft, turnRight), "span, growx");
        controls.add(row(beside, guide), "span, growx");
        controls.add(angles, "span, growx, wmin 0");
        controls.add(seen, "span, growx, wmin 0");
        addSlider(
                controls,
                "Depth",
                "Depth of the image, mm",
                "%.0f mm",
                new int[] {60, 240, 150},
                1,
                mm -> probe.changeSettings(s -> s.withDepth(mm)));
        addSlider(
                controls,
                "Gain",
                "Overall gain, dB",
                "%.0f dB",
                new int[] {-30, 30, 0},
                1,
                db -> probe.changeSettings(s -> s.withGain(db)));
        addSlider(
                controls,
                "Time gain",
                "Time-gain compensation: the attenuation that it makes up for, dB/cm at 1 MHz",
                "%.2f dB/cm",
                new int[] {0, 30, 10},
                0.05,
                db -> probe.changeSettings(s -> s.withDepthGain(db)));
        addSlider(
                controls,
                "Latency",
                "Time from the moment of an image to its display, s",
                "%.2f s",
                new int[] {0, 20, (int) Math.round(GuidanceSettings.DEFAULT_LATENCY_S / LATENCY_STEP_S)},
                LATENCY_STEP_S,
                rehearsal.pictures()::setLatencyS);
        add(view, "hmin 120, grow");
        add(controls, "wmin 0");
        follow(session);
    }

    private static final double LATENCY_STEP_S = 0.025;

    /** @param range least, greatest and first position */
    private static void addSlider(
            JPanel panel, String name, String tip, String format, int[] range, double perStep, DoubleConsumer set) {
        JSlider slider = Controls.describe(Controls.slider(range[0], range[1], range[2]), name, tip);
        JLabel value = new JLabel(NumberFormats.text(format, perStep * range[2]));
        slider.addChangeListener(e -> {
            value.setText(NumberFormats.text(format, perStep * slider.getValue()));
            set.accept(perStep * slider.getValue());
        });
        panel.add(new JLabel(name));
        panel.add(slider, "wmin 0");
        panel.add(value, "wmin 0");
    }

    private void showGuide() {
        view.setGuided(guide.isSelected());
    }

    public UltrasoundView view() {
        return view;
    }

    @Override
    public void onState() {
        boolean held = probe.hold().isPresent();
        put.setSelected(rehearsal.pickMode().mode() == PickMode.Kind.PROBE);
        setEnabled(isReady(), put);
        setEnabled(isReady() && held, lift, beside, turnLeft, turnRight);
        view.setOutlined(rehearsal.pictures().aids() != Aids.PICTURES);
        if (!held && isReady()) {
            view.show(Optional.empty(), NO_PROBE);
        }
        showAngles();
    }

    @Override
    public void onUltrasound(Optional<UltrasoundShot> shot) {
        view.show(shot, NO_PROBE);
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            showAngles();
        }
    }

    private void showAngles() {
        ProbePose.Angles a = probe.angles();
        angles.setText(NumberFormats.text(
                "Rotated %.0f\u00b0, tilted %.0f\u00b0, rocked %.0f\u00b0", a.rotationDeg(), a.tiltDeg(), a.rockDeg()));
        Optional<ProbeState> state = rehearsal.state().flatMap(s -> s.probe());
        boolean inside =
                rehearsal.state().filter(s -> s.placed() && s.depthMm() > 0).isPresent();
        boolean told = rehearsal.pictures().aids() != Aids.PICTURES;
        seen.setText(
                !told || !inside || state.isEmpty()
                        ? " "
                        : NumberFormats.text(
                                "Needle in the beam: %.0f mm%s",
                                state.get().needleInBeamMm(),
                                state.get().tipInBeam() ? ", with its tip" : ", not its tip"));
    }
}
