package org.phrenic.ui.access.panel;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;

/** What moves the needle, how deep it is, and how its tip lies to the target. */
final class NeedlePanel extends JPanel implements Session.Listener, RehearsalListener {
    private static final double STEP_MM = 2;
    private static final int DEFAULT_LENGTH_MM = 150;
    private static final Double[] SPEEDS = {10.0, 25.0, 50.0, 100.0, 200.0};

    private final transient RehearsalController door;
    private final JSlider depth = new JSlider(0, DEFAULT_LENGTH_MM, 0);
    private final JLabel depthText = new JLabel("Not in the body");
    private final WrappingLabel miss = WrappingLabel.emphasised("Tip to target");
    private final JButton insert = new JButton("Insert");
    private final JButton withdraw = new JButton("Withdraw");
    private final JButton toTargetButton = new JButton("Go to target");
    private final JButton aim = new JButton("Aim again");
    private final JButton sample = new JButton("Take sample");
    private final JButton removeButton = new JButton("Take out");
    private final JComboBox<Double> speed = new JComboBox<>(SPEEDS);
    private boolean updating;

    NeedlePanel(Session session, RehearsalController door) {
        super(PanelRows.columnLayout());
        this.door = door;
        PanelRows.describe(
                depth,
                "Depth of the tip",
                "Drag to insert or withdraw; so do the wheel over the view and the keys I and W");
        depth.addChangeListener(e -> {
            if (!updating) {
                door.needle().moveTo(depth.getValue());
            }
        });
        JPanel first = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill, 0::][]"));
        first.add(depthText, "wmin 0");
        first.add(speed);
        add(first, "wmin 0");
        add(depth, "wmin 0");
        PanelRows.describe(insert, "Insert", "2 mm deeper (I, or the wheel)");
        PanelRows.describe(withdraw, "Withdraw", "2 mm back (W, or the wheel)");
        PanelRows.describe(toTargetButton, "Go to target", "As deep as the target lies (G)");
        PanelRows.describe(
                aim, "Aim again", "Point the needle at where the target is now; not while the tip is in the liver (A)");
        PanelRows.describe(sample, "Take sample", "Take a sample where the tip is (X)");
        PanelRows.describe(
                removeButton,
                "Take out",
                "Withdraw the needle all the way (O); after a sample the attempt ends with that");
        PanelRows.describe(speed, "Speed of the needle", "How fast the needle moves, mm a second");
        speed.setSelectedItem(50.0);
        speed.setRenderer(new SpeedRenderer());
        speed.addActionListener(e -> door.needle().setSpeedMmPerS((Double) speed.getSelectedItem()));
        insert.addActionListener(e -> door.needle().moveBy(STEP_MM));
        withdraw.addActionListener(e -> door.needle().moveBy(-STEP_MM));
        toTargetButton.addActionListener(e -> door.needle().moveToTarget());
        aim.addActionListener(e -> door.needle().aimAtTarget());
        sample.addActionListener(e -> door.needle().takeSample());
        removeButton.addActionListener(e -> door.needle().moveTo(0));
        add(PanelRows.row(insert, withdraw, toTargetButton), "wmin 0");
        add(miss, "wmin 0");
        add(PanelRows.row(aim, sample, removeButton), "wmin 0");
        onState();
        session.addListener(this);
        door.addListener(this);
    }

    private static final class SpeedRenderer extends javax.swing.DefaultListCellRenderer {
        @Override
        public java.awt.Component getListCellRendererComponent(
                javax.swing.JList<?> list, Object value, int index, boolean selected, boolean focus) {
            String text = String.format(Locale.ROOT, "%.0f mm/s", (Double) value);
            return super.getListCellRendererComponent(list, text, index, selected, focus);
        }
    }

    @Override
    public void onState() {
        updating = true;
        boolean ready = door.stage() == RehearsalStage.READY;
        for (JComponent control : new JComponent[] {depth, insert, toTargetButton}) {
            control.setEnabled(ready);
        }
        door.plan().ifPresent(plan -> depth.setMaximum((int) plan.needle().lengthMm()));
        updating = false;
        refreshNeedle();
    }

    @Override
    public void onTick(RunStatus status) {
        if (isShowing()) {
            refreshNeedle();
        }
    }

    private void refreshNeedle() {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        boolean placed = state.filter(NeedleState::placed).isPresent();
        depthText.setText(
                placed
                        ? String.format(
                                Locale.ROOT,
                                "Depth %.0f of %.0f mm",
                                state.get().depthMm(),
                                state.get().aimedDepthMm())
                        : "Not in the body");
        miss.setTextIfChanged(state.flatMap(NeedleState::targetingError)
                .map(NeedlePanel::describe)
                .orElse("Tip to target: -"));
        if (!depth.getValueIsAdjusting()) {
            updating = true;
            depth.setValue((int) Math.round(state.map(NeedleState::depthMm).orElse(0.0)));
            updating = false;
        }
        boolean usable = placed && door.stage() == RehearsalStage.READY;
        for (JComponent control : new JComponent[] {aim, sample, removeButton, withdraw}) {
            control.setEnabled(usable);
        }
    }

    private static String describe(TargetingError miss) {
        return String.format(
                Locale.ROOT,
                "Tip to target %.1f mm: %.1f %s, %.1f aside%s",
                miss.distanceMm(),
                Math.abs(miss.axialMm()),
                miss.axialMm() < 0 ? "too deep" : "to go",
                miss.lateralMm(),
                miss.hit() ? ", in it" : "");
    }
}
