package org.phrenic.ui.access.panel;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JFormattedTextField;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JSpinner;
import javax.swing.JToggleButton;
import javax.swing.SpinnerNumberModel;
import javax.swing.text.DefaultFormatterFactory;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.TargetMotion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.file.Numbers;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.ListKeys;

/**
 * The target: its motion with the breath, and place and size of a target for practice, or a lesion that the body shows;
 * progress until it is computed.
 */
final class TargetPanel extends AccessPanel {
    /** Default and range of diameters for practice, mm. */
    private static final int DEFAULT_MM = 20;

    private static final int SMALLEST_MM = 5;
    private static final int LARGEST_MM = 50;

    private static final String OTHER_TARGET = "another target in the liver";

    private final WrappingLabel motion = WrappingLabel.emphasised("How far the target moves");
    private final WrappingLabel directions = WrappingLabel.secondary("In which direction it moves");
    private final JProgressBar progress = new JProgressBar(0, 100);
    private final JToggleButton setTarget = toggle(
            "Set target",
            "Set target",
            "Then click on the liver: the target lies behind that place (T)",
            () -> rehearsal.pickMode().toggle(PickMode.Kind.TARGET));
    private final JSpinner size = new JSpinner(new SpinnerNumberModel(DEFAULT_MM, SMALLEST_MM, LARGEST_MM, 1));
    private final JPanel practiceRow =
            new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill][][60!][]"));
    private final JComboBox<String> lesion = ListKeys.chooseByEnter(new JComboBox<>());
    private List<ScannedLesion> lesions = List.of();
    private boolean updating;

    TargetPanel(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("Progress of the preparation");
        JFormattedTextField sizeField = ((JSpinner.DefaultEditor) size.getEditor()).getTextField();
        sizeField.setFormatterFactory(
                new DefaultFormatterFactory(new DiameterFormatter(SMALLEST_MM, LARGEST_MM, session::refuse)));
        Controls.describe(size, "Diameter of the target", "Diameter of the target, mm");
        Controls.describe(sizeField, "Diameter of the target, mm", "Diameter of the target, mm");
        size.addChangeListener(e -> {
            if (!updating) {
                rehearsal.setTargetMm(((Number) size.getValue()).doubleValue());
            }
        });
        Controls.describe(lesion, "Lesion", "The lesion of this body that is the target");
        lesion.setName("rehearsal.lesion");
        lesion.addActionListener(e -> {
            int chosen = lesion.getSelectedIndex();
            if (updating || chosen < 0) {
                return;
            }
            if (chosen < lesions.size()) {
                rehearsal.setTarget(lesions.get(chosen));
            } else if (!setTarget.isSelected()) {
                setTarget.doClick();
            }
        });
        practiceRow.add(setTarget);
        practiceRow.add(new JLabel("Size"));
        practiceRow.add(size, "growx");
        practiceRow.add(new JLabel("mm"));
        addAll(progress, motion, directions, lesion, practiceRow);
        follow(session);
    }

    @Override
    public void onState() {
        updating = true;
        boolean practice = rehearsal.exercise().isEmpty();
        practiceRow.setVisible(practice);
        setTarget.setSelected(rehearsal.pickMode().mode() == PickMode.Kind.TARGET);
        showLesions();
        lesion.setVisible(practice && !lesions.isEmpty());
        setEnabled(isReady() && practice, setTarget, size, lesion);
        showProgress();
        showMotion();
        updating = false;
    }

    /** Lists the lesions of the body and selects the one that is the target. */
    private void showLesions() {
        if (!lesions.equals(rehearsal.lesions())) {
            lesions = rehearsal.lesions();
            lesion.removeAllItems();
            lesions.forEach(one -> lesion.addItem(
                    Numbers.format("%s, %.0f mm", one.label(), one.target().diameterMm())));
            lesion.addItem(OTHER_TARGET);
        }
        Optional<TargetLesion> target = rehearsal.study().map(TargetAccess::target);
        int chosen = lesions.size();
        for (int i = 0; i < lesions.size() && target.isPresent(); i++) {
            chosen = isSame(lesions.get(i).target(), target.get()) ? i : chosen;
        }
        lesion.setSelectedIndex(lesions.isEmpty() ? -1 : chosen);
    }

    private static boolean isSame(TargetLesion one, TargetLesion other) {
        return one.diameterMm() == other.diameterMm() && Arrays.equals(one.restMm(), other.restMm());
    }

    private void showProgress() {
        String doing =
                switch (rehearsal.stage()) {
                    case LOADING -> "Building the body";
                    case RECORDING_BREATH -> "Recording one breath";
                    case MAPPING -> "Computing the free paths";
                    case READY, PLAYING, CLOSED, UNAVAILABLE -> "";
                };
        progress.setVisible(!doing.isEmpty());
        progress.setString(doing);
        progress.setIndeterminate(rehearsal.stage() != RehearsalStage.RECORDING_BREATH);
        progress.setValue((int) (100 * rehearsal.recordedFraction()));
    }

    private void showMotion() {
        Optional<TargetAccess> study = rehearsal.study();
        if (study.isEmpty()) {
            boolean unavailable = rehearsal.stage() == RehearsalStage.UNAVAILABLE;
            motion.setTextIfChanged(
                    unavailable
                            ? Controls.capitalise(rehearsal.unavailableReason())
                            : "Measuring how the target moves");
            directions.setTextIfChanged(" ");
            return;
        }
        TargetMotion moves = study.get().map().motion();
        double[] range = moves.rangeMm();
        double diameter = study.get().target().diameterMm();
        motion.setTextIfChanged(Numbers.format("Target moves %.0f mm with the breath", moves.excursionMm()));
        directions.setTextIfChanged(Numbers.format(
                "%.0f mm up-down, %.0f front-back, %.0f sideways\nDiameter of the target %.0f mm",
                range[2], range[1], range[0], diameter));
        size.setValue((int) Math.round(diameter));
    }
}
