package org.phrenic.ui;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import org.phrenic.rehearsal.Miss;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.simulation.live.Status;
import org.phrenic.ui.clinic.Words;

/** What moves the needle, how deep it is, and how its tip lies to the target. */
final class NeedleSection extends JPanel implements Session.Events, DoorEvents {
    private static final double STEP_MM = 2;
    private static final int USUAL_LENGTH_MM = 150;
    private static final Double[] SPEEDS = {10.0, 25.0, 50.0, 100.0, 200.0};

    private final transient RehearsalDoor door;
    private final JSlider depth = new JSlider(0, USUAL_LENGTH_MM, 0);
    private final JLabel depthText = new JLabel("Not in the body");
    private final Words miss = Words.bold("Tip to target");
    private final JButton insert = new JButton("Insert");
    private final JButton withdraw = new JButton("Withdraw");
    private final JButton toTarget = new JButton("Go to target");
    private final JButton aim = new JButton("Aim again");
    private final JButton sample = new JButton("Take sample");
    private final JButton out = new JButton("Take out");
    private final JComboBox<Double> speed = new JComboBox<>(SPEEDS);
    private boolean showing;

    NeedleSection(Session session, RehearsalDoor door) {
        super(ClinicRow.section());
        this.door = door;
        ClinicRow.named(
                depth,
                "Depth of the tip",
                "Drag to insert or withdraw; so do the wheel over the view and the keys I and W");
        depth.addChangeListener(e -> {
            if (!showing) {
                door.hand().moveTo(depth.getValue());
            }
        });
        JPanel first = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill, 0::][]"));
        first.add(depthText, "wmin 0");
        first.add(speed);
        add(first, "wmin 0");
        add(depth, "wmin 0");
        ClinicRow.named(insert, "Insert", "2 mm deeper (I, or the wheel)");
        ClinicRow.named(withdraw, "Withdraw", "2 mm back (W, or the wheel)");
        ClinicRow.named(toTarget, "Go to target", "As deep as the target lies (G)");
        ClinicRow.named(
                aim, "Aim again", "Point the needle at where the target is now; not while the tip is in the liver (A)");
        ClinicRow.named(sample, "Take sample", "Take a sample where the tip is (X)");
        ClinicRow.named(
                out, "Take out", "Withdraw the needle all the way (O); after a sample the attempt ends with that");
        ClinicRow.named(speed, "Speed of the needle", "How fast the needle moves, mm a second");
        speed.setSelectedItem(50.0);
        speed.setRenderer(new SpeedText());
        speed.addActionListener(e -> door.hand().setSpeedMmPerS((Double) speed.getSelectedItem()));
        insert.addActionListener(e -> door.hand().moveBy(STEP_MM));
        withdraw.addActionListener(e -> door.hand().moveBy(-STEP_MM));
        toTarget.addActionListener(e -> door.hand().moveToTarget());
        aim.addActionListener(e -> door.hand().aim());
        sample.addActionListener(e -> door.hand().sample());
        out.addActionListener(e -> door.hand().moveTo(0));
        add(ClinicRow.of(insert, withdraw, toTarget), "wmin 0");
        add(miss, "wmin 0");
        add(ClinicRow.of(aim, sample, out), "wmin 0");
        onDoor();
        session.listen(this);
        door.listen(this);
    }

    private static final class SpeedText extends javax.swing.DefaultListCellRenderer {
        @Override
        public java.awt.Component getListCellRendererComponent(
                javax.swing.JList<?> list, Object value, int index, boolean selected, boolean focus) {
            String text = String.format(Locale.ROOT, "%.0f mm/s", (Double) value);
            return super.getListCellRendererComponent(list, text, index, selected, focus);
        }
    }

    @Override
    public void onDoor() {
        showing = true;
        boolean ready = door.stage() == DoorStage.READY;
        for (JComponent control : new JComponent[] {depth, insert, toTarget}) {
            control.setEnabled(ready);
        }
        door.plan().ifPresent(plan -> depth.setMaximum((int) plan.needle().lengthMm()));
        showing = false;
        needleNow();
    }

    @Override
    public void onTick(Status status) {
        if (isShowing()) {
            needleNow();
        }
    }

    private void needleNow() {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        boolean placed = state.filter(NeedleState::placed).isPresent();
        depthText.setText(
                placed
                        ? String.format(
                                Locale.ROOT,
                                "Depth %.0f of %.0f mm",
                                state.get().depthMm(),
                                state.get().aimedMm())
                        : "Not in the body");
        miss.say(state.flatMap(NeedleState::miss).map(NeedleSection::words).orElse("Tip to target: -"));
        if (!depth.getValueIsAdjusting()) {
            showing = true;
            depth.setValue((int) Math.round(state.map(NeedleState::depthMm).orElse(0.0)));
            showing = false;
        }
        boolean usable = placed && door.stage() == DoorStage.READY;
        for (JComponent control : new JComponent[] {aim, sample, out, withdraw}) {
            control.setEnabled(usable);
        }
    }

    private static String words(Miss miss) {
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
