package org.phrenic.ui.access.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.NeedleController;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/** Controls of the needle, its depth, and the distance of its tip, or of the middle of its core, from the target. */
final class NeedlePanel extends AccessPanel {
    private static final double STEP_MM = 2;
    private static final int DEFAULT_LENGTH_MM = 150;
    private static final Double[] SPEEDS_MM_PER_S = {10.0, 25.0, 50.0, 100.0, 200.0};

    private final JSlider depth = Controls.describe(
            Controls.slider(0, DEFAULT_LENGTH_MM, 0),
            "Depth of the tip",
            "Drag to insert or withdraw; so do the wheel over the view and the keys I and W");
    private final JLabel depthText = new JLabel("Not in the body");
    private final JLabel angles = Controls.secondaryLabel(" ");
    private final WrappingLabel error = WrappingLabel.emphasised("Tip to target");
    private final JLabel parts = Controls.secondaryLabel(" ");
    private final JLabel loads = Controls.secondaryLabel(" ");
    private final transient NeedleController needle = rehearsal.needle();
    private final JButton insert =
            button("Insert", "2 mm deeper (I, or the wheel; 10 mm with Shift)", () -> needle.moveBy(STEP_MM));
    private final JButton withdraw =
            button("Withdraw", "2 mm back (W, or the wheel; 10 mm with Shift)", () -> needle.moveBy(-STEP_MM));
    private final JButton toTarget = button(
            "Go to target", "As deep as where the needle passes nearest to the target (G)", needle::moveToTarget);
    private final JButton aim = button(
            "Aim for me",
            "The program points the needle at the target, which the report says; not while the tip is in the liver (A)",
            needle::aimAtTarget);
    private final JButton sample = button("Take sample", "Take a sample where the tip is (X)", needle::takeSample);
    private final JButton remove = button(
            "Take out",
            "Withdraw the needle all the way (O); after a sample the attempt ends with that",
            () -> needle.moveTo(0));
    private final transient Session session;
    private int samplesTold;
    private boolean updating;

    NeedlePanel(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        this.session = session;
        JComboBox<Double> speed = Controls.describe(
                new JComboBox<>(SPEEDS_MM_PER_S), "Speed of the needle", "How fast the needle moves, mm per second");
        speed.setSelectedItem(50.0);
        speed.setRenderer(Controls.renderer(mmPerS -> Numbers.format("%.0f mm/s", mmPerS)));
        speed.addActionListener(e -> needle.setSpeedMmPerS((Double) speed.getSelectedItem()));
        depth.addChangeListener(e -> {
            if (!updating) {
                needle.moveTo(depth.getValue());
            }
        });
        JPanel first = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill, 0::][]"));
        first.add(depthText, "wmin 0");
        first.add(speed);
        parts.setToolTipText("Distance from the tip, or of a core needle from the middle of the core that it would"
                + " throw, to the middle of the target along the needle, and aside of it");
        loads.setToolTipText("Force along the needle and the layer it comes from; force aside, which bends the needle");
        angles.setToolTipText(
                "Angles of the needle: 0 in the axial plane is straight back, 90 to the patient's left; the"
                        + " arrow keys turn it, and so does dragging its hub");
        // Text that wraps comes first: the panel is held at its lower edge, and what is clicked stays in its place.
        addAll(error, parts, first, depth, angles, loads, row(insert, withdraw, toTarget), row(aim, sample, remove));
        follow(session);
    }

    @Override
    public void onState() {
        updating = true;
        setEnabled(isReady(), depth, insert, toTarget);
        rehearsal.plan().ifPresent(plan -> depth.setMaximum((int) plan.needle().lengthMm()));
        updating = false;
        showNeedle();
    }

    @Override
    public void onTick(RunStatus status) {
        // A sample is told of whichever tab is shown.
        tellSamples(rehearsal.state().map(NeedleState::samples).orElse(0));
        if (isShowing()) {
            showNeedle();
        }
    }

    private void showNeedle() {
        Optional<NeedleState> state = rehearsal.state().filter(NeedleState::hasNeedle);
        Optional<NeedleState> placed = state.filter(NeedleState::placed);
        depthText.setText(placed.map(s -> error.isVisible()
                        ? Numbers.format("Depth %.0f of %.0f mm", s.depthMm(), s.targetDepthMm())
                        : Numbers.format("Depth %.0f mm", s.depthMm()))
                .orElse("Not in the body"));
        Optional<TargetingError> distance = state.flatMap(NeedleState::targetingError);
        error.setVisible(rehearsal.pictures().aids() != Aids.PICTURES);
        error.setTextIfChanged(distance.map(NeedlePanel::text).orElse("Tip to target: -"));
        parts.setVisible(error.isVisible());
        parts.setText(distance.map(NeedlePanel::parts).orElse(" "));
        if (!depth.getValueIsAdjusting()) {
            updating = true;
            depth.setValue((int) Math.round(state.map(NeedleState::depthMm).orElse(0.0)));
            updating = false;
        }
        angles.setText(state.map(s -> Numbers.format(
                        "%.0f\u00b0 in the axial plane, %.0f\u00b0 to the %s",
                        s.angles().axialDeg(),
                        Math.abs(s.angles().cranialDeg()),
                        s.angles().cranialDeg() < 0 ? "feet" : "head"))
                .orElse(" "));
        loads.setText(
                state.map(s -> text(s.load())).filter(text -> !text.isEmpty()).orElse(" "));
        setEnabled(state.isPresent() && isReady(), aim);
        setEnabled(placed.isPresent() && isReady(), sample, remove, withdraw);
    }

    private void tellSamples(int taken) {
        if (taken > samplesTold) {
            session.note(isReady() ? "Sample taken. Take out (O) ends the attempt." : "Sample taken.");
        }
        samplesTold = taken;
    }

    /** Whether the distance of the tip from the target is told. */
    boolean isTold() {
        return error.isVisible();
    }

    /** Forces in words, such as "1.3 N from the capsule, 0.4 N aside"; empty if there is none to tell. */
    static String text(NeedleLoad load) {
        List<String> words = new ArrayList<>();
        if (!load.layer().isEmpty()) {
            words.add(Numbers.format("%.1f N from the %s", load.axialN(), load.layer()));
        }
        if (load.sideN() >= 0.1) {
            words.add(Numbers.format("%.1f N aside", load.sideN()));
        }
        return String.join(", ", words);
    }

    /** The distance that a sample would have now: that of the tip, or of the middle of a core. */
    static String text(TargetingError error) {
        if (error.coreInTargetMm().isEmpty()) {
            return Numbers.format("Tip to target %.1f mm%s", error.distanceMm(), error.hit() ? ", in it" : "");
        }
        return Numbers.format(
                "Middle of the core to target %.1f mm, %.1f mm of the core in it",
                error.distanceMm(), error.coreInTargetMm().getAsDouble());
    }

    static String parts(TargetingError error) {
        return Numbers.format(
                "%.1f mm %s, %.1f mm aside",
                Math.abs(error.axialMm()), error.axialMm() < 0 ? "too deep" : "to go", error.lateralMm());
    }
}
