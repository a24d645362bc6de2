package org.phrenic.ui.access.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;

/** What is rehearsed: free practice, or an exercise with a goal. */
final class ExercisePanel extends JPanel implements RehearsalListener {
    private static final String PRACTICE =
            "Press T and click on the liver for a target, E and click on the skin for an entry, or take the best path. Scroll to insert.";

    private final transient RehearsalController door;
    private final JComboBox<String> exercise = new JComboBox<>();
    private final WrappingLabel description = WrappingLabel.secondary("About the exercise");
    private final JButton restartButton = new JButton("Begin again");
    private final JButton demoButton = new JButton("Show me");
    private final transient List<RehearsalPlan> exercises = new ArrayList<>(RehearsalPlan.exercises());
    private boolean updating;

    ExercisePanel(RehearsalController door) {
        super(PanelRows.columnLayout());
        this.door = door;
        exercise.addItem("Practice: a target of your own");
        exercises.forEach(this::addExercise);
        PanelRows.describe(exercise, "Exercise", "What is rehearsed: free practice, or an exercise with a goal");
        exercise.addActionListener(e -> onSelection());
        add(exercise, "wmin 0");
        add(description, "wmin 0");
        PanelRows.describe(restartButton, "Begin again", "The same target again, from the start (R)");
        PanelRows.describe(demoButton, "Show me", "Plays the exercise as an example");
        restartButton.addActionListener(e -> door.retry());
        demoButton.addActionListener(e -> door.playExample());
        add(PanelRows.row(restartButton, demoButton), "wmin 0");
        onState();
        door.addListener(this);
    }

    private void addExercise(RehearsalPlan plan) {
        exercise.addItem(plan.title() + (plan.difficulty().isEmpty() ? "" : " (" + plan.difficulty() + ")"));
    }

    private void onSelection() {
        if (!updating) {
            int chosen = exercise.getSelectedIndex();
            if (chosen == 0) {
                door.startPractice();
            } else {
                door.open(exercises.get(chosen - 1));
            }
        }
    }

    @Override
    public void onState() {
        updating = true;
        Optional<RehearsalPlan> chosen = door.exercise();
        exercise.setSelectedIndex(1 + chosen.map(this::indexOf).orElse(-1));
        description.setTextIfChanged(chosen.map(this::describe).orElse(PRACTICE));
        restartButton.setEnabled(door.study().isPresent() && door.stage().canStartAttempt());
        demoButton.setEnabled(restartButton.isEnabled()
                && chosen.filter(plan -> !plan.steps().isEmpty()).isPresent());
        updating = false;
    }

    /** Which of the exercises it is; one of another file is listed from now on. */
    private int indexOf(RehearsalPlan plan) {
        for (int i = 0; i < exercises.size(); i++) {
            if (exercises.get(i).title().equals(plan.title())
                    && exercises.get(i).file().equals(plan.file())) {
                return i;
            }
        }
        exercises.add(plan);
        addExercise(plan);
        return exercises.size() - 1;
    }

    /** What it is, until an entry is chosen, and what counts as done. */
    private String describe(RehearsalPlan plan) {
        String description = door.entrySelection().advice().isPresent() ? "" : plan.description() + " ";
        return description + "Done when: " + String.join("; ", plan.goals().describe()) + ".";
    }
}
