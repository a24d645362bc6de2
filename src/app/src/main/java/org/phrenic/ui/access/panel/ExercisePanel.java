package org.phrenic.ui.access.panel;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.ListKeys;

/** Chooses free practice or an exercise with goals. */
final class ExercisePanel extends AccessPanel {
    private static final String PRACTICE = "Press T and click on the liver for a target, E and click on the skin for an"
            + " entry, or take the best one. Scroll to insert.";
    private static final String LIST_TIP = "What is rehearsed: free practice, or an exercise with a goal";
    private static final String PRACTICE_ENTRY = "Practice: a target of your own";
    /** Names at the end of a file's path that are shown: folder and file. */
    private static final int SHOWN_NAMES = 2;

    private final JComboBox<ListedExercise> exercise = Controls.describe(new JComboBox<>(), "Exercise", LIST_TIP);
    private final WrappingLabel description = WrappingLabel.secondary("About the exercise");
    private final JButton restart =
            button("Begin again", "The same target again, from the start (R)", rehearsal::retry);
    private final JButton demo = button("Show me", "Plays the exercise as an example", rehearsal::playExample);
    private final transient List<ListedExercise> exercises = new ArrayList<>();
    private final JComboBox<Aids> aids = Controls.describe(
            new JComboBox<>(Aids.values()), "Help", "What is shown: the see-through body, sections, pictures alone");
    private boolean updating;

    /** An entry of the list, equal to itself alone: several exercises may have one title. */
    private final class ListedExercise {
        private final Optional<RehearsalPlan> plan;

        private ListedExercise(Optional<RehearsalPlan> plan) {
            this.plan = plan;
        }

        private String label() {
            return plan.map(of -> of.title() + (of.difficulty().isEmpty() ? "" : " (" + of.difficulty() + ")"))
                    .orElse(PRACTICE_ENTRY);
        }

        /** The title, with the end of the file's path where another exercise of the list has the same title. */
        @Override
        public String toString() {
            boolean alone = exercises.stream().noneMatch(other -> other != this && label().equals(other.label()));
            return alone
                    ? label()
                    : label() + ", " + plan.map(of -> endOfPath(of.file())).orElse("");
        }
    }

    private static String endOfPath(String file) {
        Path path = Path.of(file);
        int names = path.getNameCount();
        return path.subpath(Math.max(0, names - SHOWN_NAMES), names).toString();
    }

    ExercisePanel(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        ListKeys.chooseByEnter(exercise);
        ListKeys.chooseByEnter(aids);
        exercise.addItem(new ListedExercise(Optional.empty()));
        RehearsalPlan.exercises().forEach(this::addExercise);
        exercise.addActionListener(e -> onSelection());
        aids.setRenderer(Controls.renderer(value -> ((Aids) value).label()));
        aids.addActionListener(e -> {
            if (!updating) {
                rehearsal.setAids((Aids) aids.getSelectedItem());
            }
        });
        JPanel help = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[][grow, fill, 0::]"));
        help.add(new JLabel("Help"));
        help.add(aids, "wmin 0");
        addAll(exercise, description, row(restart, demo), help);
        follow(session);
    }

    private void addExercise(RehearsalPlan plan) {
        ListedExercise added = new ListedExercise(Optional.of(plan));
        exercises.add(added);
        exercise.addItem(added);
    }

    private void onSelection() {
        if (!updating && exercise.getSelectedItem() instanceof ListedExercise chosen) {
            chosen.plan.ifPresentOrElse(rehearsal::open, rehearsal::startPractice);
        }
    }

    @Override
    public void onState() {
        updating = true;
        Optional<RehearsalPlan> chosen = rehearsal.exercise();
        exercise.setSelectedIndex(1 + chosen.map(this::indexOf).orElse(-1));
        description.setTextIfChanged(chosen.map(ExercisePanel::text).orElse(PRACTICE));
        // What is said of the path has the room once there is an entry; the exercise stays at hand as a tip.
        description.setVisible(rehearsal.entrySelection().entry().isEmpty());
        exercise.setToolTipText(
                description.isVisible()
                        ? LIST_TIP
                        : "<html><body width='360'>" + Controls.escapeHtml(description.getText()));
        restart.setEnabled(rehearsal.study().isPresent() && rehearsal.stage().canStartAttempt());
        demo.setEnabled(restart.isEnabled()
                && chosen.filter(plan -> !plan.steps().isEmpty()).isPresent());
        aids.setSelectedItem(rehearsal.pictures().aids());
        updating = false;
    }

    /** Index in the list of exercises; a plan from another file is added to it, one from the same file replaces it. */
    private int indexOf(RehearsalPlan plan) {
        for (int i = 0; i < exercises.size(); i++) {
            RehearsalPlan listed = exercises.get(i).plan.orElseThrow();
            if (listed.file().equals(plan.file())) {
                if (!listed.equals(plan)) {
                    replaceExercise(i, plan);
                }
                return i;
            }
        }
        addExercise(plan);
        return exercises.size() - 1;
    }

    private void replaceExercise(int index, RehearsalPlan plan) {
        ListedExercise other = new ListedExercise(Optional.of(plan));
        exercises.set(index, other);
        exercise.insertItemAt(other, index + 1);
        exercise.removeItemAt(index + 2);
    }

    /** Description, and goals if there are any. */
    private static String text(RehearsalPlan plan) {
        List<String> goals = plan.goals().describe();
        String done = goals.isEmpty() ? "" : "Done when: " + String.join("; ", goals) + ".";
        return (plan.description() + " " + done).strip();
    }
}
