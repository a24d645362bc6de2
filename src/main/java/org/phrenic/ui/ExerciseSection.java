package org.phrenic.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.ui.clinic.Words;

/** What is rehearsed: free practice, or an exercise with a goal. */
final class ExerciseSection extends JPanel implements DoorEvents {
    private static final String PRACTICE =
            "Press T and click on the liver for a target, E and click on the skin for an entry, or take the best path. Scroll to insert.";

    private final transient RehearsalDoor door;
    private final JComboBox<String> exercise = new JComboBox<>();
    private final Words about = Words.quiet("About the exercise");
    private final JButton begin = new JButton("Begin again");
    private final JButton show = new JButton("Show me");
    private final transient List<RehearsalPlan> exercises = new ArrayList<>(RehearsalPlan.exercises());
    private boolean showing;

    ExerciseSection(RehearsalDoor door) {
        super(ClinicRow.section());
        this.door = door;
        exercise.addItem("Practice: a target of your own");
        exercises.forEach(this::list);
        ClinicRow.named(exercise, "Exercise", "What is rehearsed: free practice, or an exercise with a goal");
        exercise.addActionListener(e -> pickExercise());
        add(exercise, "wmin 0");
        add(about, "wmin 0");
        ClinicRow.named(begin, "Begin again", "The same target again, from the start (R)");
        ClinicRow.named(show, "Show me", "Plays the exercise as an example");
        begin.addActionListener(e -> door.retry());
        show.addActionListener(e -> door.demonstrate());
        add(ClinicRow.of(begin, show), "wmin 0");
        onDoor();
        door.listen(this);
    }

    private void list(RehearsalPlan plan) {
        exercise.addItem(plan.title() + (plan.difficulty().isEmpty() ? "" : " (" + plan.difficulty() + ")"));
    }

    private void pickExercise() {
        if (!showing) {
            int chosen = exercise.getSelectedIndex();
            if (chosen == 0) {
                door.practise();
            } else {
                door.open(exercises.get(chosen - 1));
            }
        }
    }

    @Override
    public void onDoor() {
        showing = true;
        Optional<RehearsalPlan> chosen = door.exercise();
        exercise.setSelectedIndex(1 + chosen.map(this::number).orElse(-1));
        about.say(chosen.map(this::words).orElse(PRACTICE));
        begin.setEnabled(door.study().isPresent() && door.stage().mayBegin());
        show.setEnabled(begin.isEnabled()
                && chosen.filter(plan -> !plan.steps().isEmpty()).isPresent());
        showing = false;
    }

    /** Which of the exercises it is; one of another file is listed from now on. */
    private int number(RehearsalPlan plan) {
        for (int i = 0; i < exercises.size(); i++) {
            if (exercises.get(i).title().equals(plan.title())
                    && exercises.get(i).file().equals(plan.file())) {
                return i;
            }
        }
        exercises.add(plan);
        list(plan);
        return exercises.size() - 1;
    }

    /** What it is, until an entry is chosen, and what counts as done. */
    private String words(RehearsalPlan plan) {
        String description = door.way().advice().isPresent() ? "" : plan.description() + " ";
        return description + "Done when: " + String.join("; ", plan.goals().words()) + ".";
    }
}
