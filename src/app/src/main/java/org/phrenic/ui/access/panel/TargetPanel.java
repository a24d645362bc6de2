package org.phrenic.ui.access.panel;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JSpinner;
import javax.swing.JToggleButton;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.access.RehearsalStage;

/**
 * The target: how far it moves with the breath, and where one of the user's own is to be. Until that is known, how far
 * it is worked out.
 */
final class TargetPanel extends JPanel implements RehearsalListener {
    private final transient RehearsalController door;
    private final WrappingLabel motion = WrappingLabel.emphasised("How far the target moves");
    private final WrappingLabel directions = WrappingLabel.secondary("In which direction it moves");
    private final JProgressBar progress = new JProgressBar(0, 100);
    private final JToggleButton setTarget = new JToggleButton("Set target");
    private final JSpinner size = new JSpinner(new SpinnerNumberModel(20, 5, 50, 1));
    private final JPanel practiceTargetRow =
            new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill][][60!][]"));
    private boolean updating;

    TargetPanel(RehearsalController door) {
        super(PanelRows.columnLayout());
        this.door = door;
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("What is being worked out");
        add(progress);
        add(motion, "wmin 0");
        add(directions, "wmin 0");
        PanelRows.describe(setTarget, "Set target", "Then click on the liver: the target lies behind that place (T)");
        setTarget.addActionListener(e -> door.pickMode().toggle(PickMode.Kind.TARGET));
        size.setToolTipText("Diameter of the target, mm");
        size.getAccessibleContext().setAccessibleName("Diameter of the target");
        ((JSpinner.DefaultEditor) size.getEditor())
                .getTextField()
                .getAccessibleContext()
                .setAccessibleName("Diameter of the target, mm");
        ((JSpinner.DefaultEditor) size.getEditor()).getTextField().setToolTipText("Diameter of the target, mm");
        size.addChangeListener(e -> {
            if (!updating) {
                door.setTargetMm(((Number) size.getValue()).doubleValue());
            }
        });
        practiceTargetRow.add(setTarget);
        practiceTargetRow.add(new JLabel("Size"));
        practiceTargetRow.add(size, "growx");
        practiceTargetRow.add(new JLabel("mm"));
        add(practiceTargetRow, "wmin 0");
        onState();
        door.addListener(this);
    }

    @Override
    public void onState() {
        updating = true;
        boolean own = door.exercise().isEmpty();
        boolean ready = door.stage() == RehearsalStage.READY && own;
        practiceTargetRow.setVisible(own);
        setTarget.setSelected(door.pickMode().mode() == PickMode.Kind.TARGET);
        setTarget.setEnabled(ready);
        size.setEnabled(ready);
        progress();
        motion();
        updating = false;
    }

    private void progress() {
        String doing =
                switch (door.stage()) {
                    case LOADING -> "Building the body";
                    case RECORDING_BREATH -> "Looking at one breath";
                    case MAPPING -> "Working out the free paths";
                    case READY, PLAYING, CLOSED, UNAVAILABLE -> "";
                };
        progress.setVisible(!doing.isEmpty());
        progress.setString(doing);
        progress.setIndeterminate(door.stage() != RehearsalStage.RECORDING_BREATH);
        progress.setValue((int) (100 * door.recordedFraction()));
    }

    private void motion() {
        Optional<TargetAccess> study = door.study();
        if (study.isEmpty()) {
            motion.setTextIfChanged(
                    door.stage() == RehearsalStage.UNAVAILABLE
                            ? door.unavailableReason()
                            : "Looking how the target moves");
            directions.setTextIfChanged(" ");
            return;
        }
        double[] range = study.get().map().motion().rangeMm();
        double wide = study.get().target().diameterMm();
        motion.setTextIfChanged(String.format(
                Locale.ROOT,
                "The target moves %.0f mm with the breath",
                study.get().map().motion().excursionMm()));
        directions.setTextIfChanged(String.format(
                Locale.ROOT,
                "%.0f up-down, %.0f front-back, %.0f sideways; %.0f mm wide",
                range[2],
                range[1],
                range[0],
                wide));
        size.setValue((int) Math.round(wide));
    }
}
