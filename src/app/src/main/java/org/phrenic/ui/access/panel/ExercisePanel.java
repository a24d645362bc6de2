package org.phrenic.ui.access.panel;

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
            + " entry, or take the best path. Scroll to insert.";

    private final JComboBox<String> exercise = Controls.describe(
            new JComboBox<>(), "Exercise", "What is rehearsed: free practice, or an exercise with a goal");
    private final WrappingLabel description = WrappingLabel.secondary("About the exercise");
    private final JButton restart =
            button("Begin again", "The same target again, from the start (R)", rehearsal::retry);
    private final JButton demo = button("Show me", "Plays the exercise as an example", rehearsal::playExample);
    private final transient List<RehearsalPlan> exercises = new ArrayList<>(RehearsalPlan.exercises());
    private final JComboBox<Aids> aids = Controls.describe(
            new JComboBox<>(Aids.values()), "Help", "What is shown: the see-through body, sections, pictures alone");
    private boolean updating;

    ExercisePanel(Session session, RehearsalController rehearsal) {
        super(rehearsal);
        ListKeys.chooseByEnter(exercise);
        ListKeys.chooseByEnter(aids);
        exercise.addItem("Practice: a target of your own");
        exercises.forEach(this::addExercise);
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
        exercise.addItem(label(plan));
    }

    private static String label(RehearsalPlan plan) {
        return plan.title() + (plan.difficulty().isEmpty() ? "" : " (" + plan.difficulty() + ")");
    }

    private void onSelection() {
        int chosen = exercise.getSelectedIndex();
        if (!updating && chosen == 0) {
            rehearsal.startPractice();
        } else if (!updating) {
            rehearsal.open(exercises.get(chosen - 1));
        }
    }

    @Override
    public void onState() {
        updating = true;
        Optional<RehearsalPlan> chosen = rehearsal.exercise();
        exercise.setSelectedIndex(1 + chosen.map(this::indexOf).orElse(-1));
        description.setTextIfChanged(chosen.map(this::text).orElse(PRACTICE));
        restart.setEnabled(rehearsal.study().isPresent() && rehearsal.stage().canStartAttempt());
        demo.setEnabled(restart.isEnabled()
                && chosen.filter(plan -> !plan.steps().isEmpty()).isPresent());
        aids.setSelectedItem(rehearsal.pictures().aids());
        updating = false;
    }

    /** Index in the list of exercises; a plan from another file is added to it, one from the same file replaces it. */
    private int indexOf(RehearsalPlan plan) {
        for (int i = 0; i < exercises.size(); i++) {
            if (exercises.get(i).file().equals(plan.file())) {
                replaceExercise(i, plan);
                return i;
            }
        }
        exercises.add(plan);
        addExercise(plan);
        return exercises.size() - 1;
    }

    private void replaceExercise(int index, RehearsalPlan plan) {
        boolean renamed = !label(plan).equals(label(exercises.get(index)));
        exercises.set(index, plan);
        if (renamed) {
            exercise.insertItemAt(label(plan), index + 1);
            exercise.removeItemAt(index + 2);
        }
    }

    /** Description until an entry is chosen, and goals if there are any. */
    private String text(RehearsalPlan plan) {
        String description = rehearsal.entrySelection().advice().isPresent() ? "" : plan.description();
        List<String> goals = plan.goals().describe();
        String done = goals.isEmpty() ? "" : "Done when: " + String.join("; ", goals) + ".";
        return (description + " " + done).strip();
    }
}
