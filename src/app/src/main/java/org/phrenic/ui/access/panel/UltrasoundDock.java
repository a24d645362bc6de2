package org.phrenic.ui.access.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.GuidanceSettings;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.ProbeController;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.access.UltrasoundShot;
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
    private final transient List<Setting> settings = new ArrayList<>();
    private boolean updating;
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
        addSetting(
                controls,
                new String[] {"Depth", "Depth of the image, mm", "%.0f mm"},
                new int[] {
                    (int) UltrasoundSettings.LEAST_DEPTH_MM,
                    (int) UltrasoundSettings.GREATEST_DEPTH_MM,
                    (int) UltrasoundSettings.DEFAULT.depthMm()
                },
                1,
                UltrasoundSettings::depthMm,
                mm -> s -> s.withDepth(mm));
        addSetting(
                controls,
                new String[] {"Gain", "Overall gain, dB", "%.0f dB"},
                new int[] {(int) -ProbeHold.MOST_GAIN_DB, (int) ProbeHold.MOST_GAIN_DB, 0},
                1,
                UltrasoundSettings::gainDb,
                db -> s -> s.withGain(db));
        addSetting(
                controls,
                new String[] {
                    "Time gain",
                    "Time-gain compensation: the attenuation that it makes up for, dB/cm at 1 MHz",
                    "%.2f dB/cm"
                },
                new int[] {
                    0,
                    (int) Math.round(ProbeHold.MOST_DEPTH_GAIN / DEPTH_GAIN_STEP),
                    (int) Math.round(UltrasoundSettings.DEFAULT.depthGainDbPerCmMhz() / DEPTH_GAIN_STEP)
                },
                DEPTH_GAIN_STEP,
                UltrasoundSettings::depthGainDbPerCmMhz,
                db -> s -> s.withDepthGain(db));
        addSlider(
                controls,
                new String[] {"Latency", "Time from the moment of an image to its display, s", "%.2f s"},
                new int[] {0, 20, (int) Math.round(GuidanceSettings.DEFAULT_LATENCY_S / LATENCY_STEP_S)},
                LATENCY_STEP_S,
                rehearsal.pictures()::setLatencyS);
        add(view, "hmin 120, grow");
        add(controls, "wmin 0");
        follow(session);
    }

    private static final double LATENCY_STEP_S = 0.025;
    /** Step of the time gain, dB/cm at 1 MHz. */
    private static final double DEPTH_GAIN_STEP = 0.05;

    /** A slider, its value beside it and that value's format. */
    private record Row(JSlider slider, JLabel text, String format, double perStep) {
        void tell(double value) {
            text.setText(Numbers.format(format, value));
            Controls.tellValue(slider, text.getText());
        }
    }

    /** A slider of the scanner, and the value that it shows; the knob is at the step nearest to it. */
    private record Setting(Row row, ToDoubleFunction<UltrasoundSettings> value) {
        void show(UltrasoundSettings shown) {
            double exact = value.applyAsDouble(shown);
            row.slider.setValue((int) Math.round(exact / row.perStep));
            row.tell(exact);
        }
    }

    /** Adds a slider of the scanner; see {@link #addSlider}. */
    private void addSetting(
            JPanel panel,
            String[] texts,
            int[] range,
            double perStep,
            ToDoubleFunction<UltrasoundSettings> value,
            DoubleFunction<UnaryOperator<UltrasoundSettings>> change) {
        Row row = addSlider(panel, texts, range, perStep, to -> {
            if (!updating) {
                probe.changeSettings(change.apply(to));
            }
        });
        settings.add(new Setting(row, value));
    }

    /**
     * Adds a slider.
     *
     * @param texts name, tooltip and format of its value
     * @param range least, greatest and first position
     */
    private static Row addSlider(JPanel panel, String[] texts, int[] range, double perStep, DoubleConsumer set) {
        String name = texts[0];
        String tip = texts[1];
        String format = texts[2];
        JSlider slider = Controls.describe(Controls.slider(range[0], range[1], range[2]), name, tip);
        Row row = new Row(slider, new JLabel(), format, perStep);
        row.tell(perStep * range[2]);
        slider.addChangeListener(e -> {
            row.tell(perStep * slider.getValue());
            set.accept(perStep * slider.getValue());
        });
        panel.add(new JLabel(name));
        panel.add(slider, "wmin 0");
        panel.add(row.text, "wmin 0");
        return row;
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
        settings.forEach(setting -> setEnabled(!isPlayed(), setting.row.slider));
        view.setOutlined(rehearsal.pictures().aids() != Aids.PICTURES);
        if (!isPlayed() && !(held && isReady())) {
            view.show(Optional.empty(), hint());
        }
        showProbe();
    }

    /** The images of the attempt before are not its own. */
    @Override
    public void onAttemptStarted() {
        view.show(Optional.empty(), hint());
    }

    /** What to do, or to wait for, for an image; nothing where the probe is held. */
    private String hint() {
        return switch (rehearsal.stage()) {
            case READY -> probe.hold().isPresent() ? "" : NO_PROBE;
            case PLAYING -> "Images come when the steps that are shown\nput a probe on the skin.";
            case LOADING, RECORDING_BREATH, MAPPING -> "Images come once the free paths\nare computed.";
            case CLOSED, UNAVAILABLE -> "";
        };
    }

    private boolean isPlayed() {
        return rehearsal.stage() == RehearsalStage.PLAYING;
    }

    @Override
    public void onUltrasound(Optional<UltrasoundShot> shot) {
        view.show(shot, hint());
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            showProbe();
        }
    }

    /** Shows how the probe is held: by hand, or by the plan that is played. */
    private void showProbe() {
        Optional<ProbeHold> played = rehearsal
                .state()
                .flatMap(NeedleState::probe)
                .map(ProbeState::hold)
                .filter(hold -> isPlayed());
        ProbePose.Angles a = played.map(ProbeHold::angles).orElseGet(probe::angles);
        updating = true;
        UltrasoundSettings shown = played.map(ProbeHold::settings).orElseGet(probe::settings);
        settings.forEach(setting -> setting.show(shown));
        updating = false;
        angles.setText(Numbers.format(
                "Rotated %.0f\u00b0, tilted %.0f\u00b0, rocked %.0f\u00b0", a.rotationDeg(), a.tiltDeg(), a.rockDeg()));
        Optional<ProbeState> state = rehearsal.state().flatMap(NeedleState::probe);
        boolean inside =
                rehearsal.state().filter(s -> s.placed() && s.depthMm() > 0).isPresent();
        boolean told = rehearsal.pictures().aids() != Aids.PICTURES;
        seen.setText(
                !told || !inside || state.isEmpty()
                        ? " "
                        : Numbers.format(
                                "Needle in the beam: %.0f mm%s",
                                state.get().needleInBeamMm(),
                                state.get().tipInBeam() ? ", with its tip" : ", not its tip"));
    }
}
