package org.phrenic.ui;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JSpinner;
import javax.swing.JToggleButton;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.ui.clinic.Words;

/** The target: how far it moves with the breath, and where one of the user's own is to be. Until that is known, how far it is worked out. */
final class TargetSection extends JPanel implements DoorEvents {
    private final transient RehearsalDoor door;
    private final Words moves = Words.bold("How far the target moves");
    private final Words moves3 = Words.quiet("In which direction it moves");
    private final JProgressBar progress = new JProgressBar(0, 100);
    private final JToggleButton setTarget = new JToggleButton("Set target");
    private final JSpinner size = new JSpinner(new SpinnerNumberModel(20, 5, 50, 1));
    private final JPanel ownTarget =
            new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill][][60!][]"));
    private boolean showing;

    TargetSection(RehearsalDoor door) {
        super(ClinicRow.section());
        this.door = door;
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("What is being worked out");
        add(progress);
        add(moves, "wmin 0");
        add(moves3, "wmin 0");
        ClinicRow.named(setTarget, "Set target", "Then click on the liver: the target lies behind that place (T)");
        setTarget.addActionListener(e -> door.clicks().choose(ClickChoice.Of.TARGET));
        size.setToolTipText("Diameter of the target, mm");
        size.getAccessibleContext().setAccessibleName("Diameter of the target");
        ((JSpinner.DefaultEditor) size.getEditor())
                .getTextField()
                .getAccessibleContext()
                .setAccessibleName("Diameter of the target, mm");
        ((JSpinner.DefaultEditor) size.getEditor()).getTextField().setToolTipText("Diameter of the target, mm");
        size.addChangeListener(e -> {
            if (!showing) {
                door.setTargetMm(((Number) size.getValue()).doubleValue());
            }
        });
        ownTarget.add(setTarget);
        ownTarget.add(new JLabel("Size"));
        ownTarget.add(size, "growx");
        ownTarget.add(new JLabel("mm"));
        add(ownTarget, "wmin 0");
        onDoor();
        door.listen(this);
    }

    @Override
    public void onDoor() {
        showing = true;
        boolean own = door.exercise().isEmpty();
        boolean ready = door.stage() == DoorStage.READY && own;
        ownTarget.setVisible(own);
        setTarget.setSelected(door.clicks().choosing() == ClickChoice.Of.TARGET);
        setTarget.setEnabled(ready);
        size.setEnabled(ready);
        progress();
        moves();
        showing = false;
    }

    private void progress() {
        String doing =
                switch (door.stage()) {
                    case LOADING -> "Building the body";
                    case LOOKING -> "Looking at one breath";
                    case MAPPING -> "Working out the free paths";
                    case READY, SHOWING, CLOSED, IMPOSSIBLE -> "";
                };
        progress.setVisible(!doing.isEmpty());
        progress.setString(doing);
        progress.setIndeterminate(door.stage() != DoorStage.LOOKING);
        progress.setValue((int) (100 * door.share()));
    }

    private void moves() {
        Optional<TargetStudy> study = door.study();
        if (study.isEmpty()) {
            moves.say(door.stage() == DoorStage.IMPOSSIBLE ? door.impossible() : "Looking how the target moves");
            moves3.say(" ");
            return;
        }
        double[] range = study.get().map().motion().rangeMm();
        double wide = study.get().target().diameterMm();
        moves.say(String.format(
                Locale.ROOT,
                "The target moves %.0f mm with the breath",
                study.get().map().motion().mostMm()));
        moves3.say(String.format(
                Locale.ROOT,
                "%.0f up-down, %.0f front-back, %.0f sideways; %.0f mm wide",
                range[2],
                range[1],
                range[0],
                wide));
        size.setValue((int) Math.round(wide));
    }
}
