package org.phrenic.ui;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JToggleButton;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.rehearsal.AccessMap;
import org.phrenic.rehearsal.BreathEvent;
import org.phrenic.rehearsal.Miss;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.Status;
import org.phrenic.ui.clinic.Legend;
import org.phrenic.ui.clinic.Verdict;
import org.phrenic.ui.clinic.Words;

/** The clinician's controls, from top to bottom in the order of use: exercise, breath, target, way in, needle. */
final class RehearsalDock extends JPanel implements Session.Events, RehearsalDoor.Events {
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");
    private static final double STEP_MM = 2;
    private static final Double[] SPEEDS = {10.0, 25.0, 50.0, 100.0, 200.0};

    private final transient Session session;
    private final transient RehearsalDoor door;
    private final transient Consumer<String> breathing;
    private final JComboBox<String> exercise = new JComboBox<>();
    private final Words about = Words.quiet("About the exercise");
    private final JButton begin = new JButton("Begin again");
    private final JButton show = new JButton("Show me");
    private final PhaseBar bar = new PhaseBar();
    private final JToggleButton quiet = new JToggleButton("Quiet");
    private final JToggleButton deep = new JToggleButton("Deep");
    private final JToggleButton holdOut = new JToggleButton("Hold at exp.");
    private final JToggleButton holdIn = new JToggleButton("Hold at insp.");
    private final Words moves = Words.bold("How far the target moves");
    private final Words moves3 = Words.quiet("In which direction it moves");
    private final JProgressBar progress = new JProgressBar(0, 100);
    private final JToggleButton setTarget = new JToggleButton("Set target");
    private final JSpinner size = new JSpinner(new SpinnerNumberModel(20, 5, 50, 1));
    private final JToggleButton setEntry = new JToggleButton("Set entry");
    private final JButton best = new JButton("Best path");
    private final JButton bestOut = new JButton("Best at expiration");
    private final Verdict overBreath = new Verdict();
    private final Verdict now = new Verdict();
    private final Legend legend = new Legend();
    private final JPanel ownTarget =
            new JPanel(new MigLayout("insets 0, gap 6, novisualpadding", "[grow, fill][][60!][]"));
    private final JSlider depth = new JSlider(0, 150, 0);
    private final JLabel depthText = new JLabel("Not in the body");
    private final Words miss = Words.bold("Tip to target");
    private final JButton insert = new JButton("Insert");
    private final JButton withdraw = new JButton("Withdraw");
    private final JButton toTarget = new JButton("Go to target");
    private final JButton aim = new JButton("Aim again");
    private final JButton sample = new JButton("Take sample");
    private final JButton out = new JButton("Take out");
    private final JComboBox<Double> speed = new JComboBox<>(SPEEDS);
    private final transient List<RehearsalPlan> exercises = new ArrayList<>(RehearsalPlan.exercises());
    private boolean showing;

    /** @param breathing told by which preset to breathe */
    RehearsalDock(Session session, RehearsalDoor door, Consumer<String> breathing) {
        super(new BorderLayout());
        this.breathing = breathing;
        this.session = session;
        this.door = door;
        setName("rehearse");
        JPanel body = new DockBody(
                new MigLayout("insets 8 10 8 10, gap 6 4, fillx, hidemode 3, wrap 1, novisualpadding", "[grow, fill]"));
        exercise(body);
        breath(body);
        target(body);
        wayIn(body);
        needle(body);
        add(DockBody.scroll(body), BorderLayout.CENTER);
        JLabel notice = new JLabel(Notice.TEXT);
        notice.putClientProperty("FlatLaf.styleClass", "small");
        JPanel foot = new JPanel(new MigLayout("insets 4 10 6 10", "[grow, fill, 0::]"));
        foot.add(notice, "wmin 0");
        add(foot, BorderLayout.SOUTH);
        onChange();
        onDoor();
        session.listen(this);
        door.listen(this);
    }

    private void exercise(JPanel body) {
        exercise.addItem("Practice: a target of your own");
        exercises.forEach(this::list);
        named(exercise, "Exercise", "What is rehearsed: free practice, or an exercise with a goal");
        exercise.addActionListener(e -> pickExercise());
        body.add(exercise, "wmin 0");
        body.add(about, "wmin 0");
        named(begin, "Begin again", "The same target again, from the start (R)");
        named(show, "Show me", "Plays the exercise as an example");
        begin.addActionListener(e -> door.retry());
        show.addActionListener(e -> door.demonstrate());
        body.add(row(begin, show), "wmin 0");
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

    private void breath(JPanel body) {
        body.add(bar, "gaptop 4");
        named(quiet, "Breathe quietly", "Quiet breathing (Q)");
        named(deep, "Breathe deeply", "Deep breathing (D)");
        named(holdOut, "Hold at expiration", "Hold the breath when air has flowed out; press again to breathe on (H)");
        named(holdIn, "Hold at inspiration", "Hold the breath when it is drawn in; press again to breathe on");
        quiet.addActionListener(e -> breathe("quiet"));
        deep.addActionListener(e -> breathe("deep"));
        holdOut.addActionListener(e -> hold(holdOut, BreathEvent.Kind.END_EXPIRATION));
        holdIn.addActionListener(e -> hold(holdIn, BreathEvent.Kind.END_INSPIRATION));
        body.add(row(quiet, deep, holdOut, holdIn), "wmin 0");
    }

    private void breathe(String preset) {
        breathing.accept(preset);
        onChange();
    }

    private void hold(JToggleButton button, BreathEvent.Kind end) {
        for (JToggleButton other : List.of(holdOut, holdIn)) {
            other.setSelected(other == button && button.isSelected());
        }
        door.hand().hold(button.isSelected() ? Optional.of(end) : Optional.empty());
    }

    private void target(JPanel body) {
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("What is being worked out");
        body.add(progress);
        body.add(moves, "wmin 0");
        body.add(moves3, "wmin 0");
        named(setTarget, "Set target", "Then click on the liver: the target lies behind that place (T)");
        setTarget.addActionListener(e -> door.choose(RehearsalDoor.Choosing.TARGET));
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
        body.add(ownTarget, "wmin 0");
    }

    private void wayIn(JPanel body) {
        named(setEntry, "Set entry", "Then click on the skin where the needle goes in (E)");
        named(best, "Best path", "The entry that is free longest, with room, on the shortest way (B)");
        named(bestOut, "Best at expiration", "The best entry for a breath held at the end of expiration");
        setEntry.addActionListener(e -> door.choose(RehearsalDoor.Choosing.ENTRY));
        best.addActionListener(e -> door.enterAtBest(false));
        bestOut.addActionListener(e -> door.enterAtBest(true));
        body.add(row(setEntry, best, bestOut), "wmin 0, gaptop 4");
        body.add(legend);
        body.add(overBreath, "wmin 0");
        body.add(now, "wmin 0");
    }

    private void needle(JPanel body) {
        named(
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
        body.add(first, "wmin 0, gaptop 4");
        body.add(depth, "wmin 0");
        named(insert, "Insert", "2 mm deeper (I, or the wheel)");
        named(withdraw, "Withdraw", "2 mm back (W, or the wheel)");
        named(toTarget, "Go to target", "As deep as the target lies (G)");
        named(aim, "Aim again", "Point the needle at where the target is now; not while the tip is in the liver (A)");
        named(sample, "Take sample", "Take a sample where the tip is (X)");
        named(out, "Take out", "Withdraw the needle all the way (O); after a sample the attempt ends with that");
        named(speed, "Speed of the needle", "How fast the needle moves, mm a second");
        speed.setSelectedItem(50.0);
        speed.setRenderer(new SpeedText());
        speed.addActionListener(e -> door.hand().setSpeedMmPerS((Double) speed.getSelectedItem()));
        insert.addActionListener(e -> door.hand().moveBy(STEP_MM));
        withdraw.addActionListener(e -> door.hand().moveBy(-STEP_MM));
        toTarget.addActionListener(e -> door.hand().moveToTarget());
        aim.addActionListener(e -> door.hand().aim());
        sample.addActionListener(e -> door.hand().sample());
        out.addActionListener(e -> door.hand().moveTo(0));
        body.add(row(insert, withdraw, toTarget), "wmin 0");
        body.add(miss, "wmin 0");
        body.add(row(aim, sample, out), "wmin 0");
    }

    private static final class SpeedText extends javax.swing.DefaultListCellRenderer {
        @Override
        public java.awt.Component getListCellRendererComponent(
                javax.swing.JList<?> list, Object value, int index, boolean selected, boolean focus) {
            String text = String.format(Locale.ROOT, "%.0f mm/s", (Double) value);
            return super.getListCellRendererComponent(list, text, index, selected, focus);
        }
    }

    private static JPanel row(JComponent... controls) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6, novisualpadding"));
        for (JComponent control : controls) {
            row.add(control, "growx, pushx, wmin 0");
        }
        return row;
    }

    private static void named(JComponent control, String name, String tip) {
        control.setName(name);
        control.getAccessibleContext().setAccessibleName(name);
        control.setToolTipText(tip);
        if (control instanceof AbstractButton button) {
            button.setMargin(new java.awt.Insets(2, 4, 2, 4));
            if (button instanceof JToggleButton toggle) {
                BreathDock.marked(toggle);
            }
        }
    }

    @Override
    public void onDoor() {
        showing = true;
        boolean ready = door.stage() == RehearsalDoor.Stage.READY;
        Optional<RehearsalPlan> chosen = door.exercise();
        exercise.setSelectedIndex(1 + chosen.map(this::number).orElse(-1));
        ownTarget.setVisible(chosen.isEmpty());
        about.say(
                chosen.map(this::words)
                        .orElse(
                                "Press T and click on the liver for a target, E and click on the skin for an entry, or take the best path. Scroll to insert."));
        setTarget.setSelected(door.choosing() == RehearsalDoor.Choosing.TARGET);
        setEntry.setSelected(door.choosing() == RehearsalDoor.Choosing.ENTRY);
        progress();
        studied();
        advised();
        boolean studied = door.study().isPresent();
        begin.setEnabled(studied && (ready || door.stage() == RehearsalDoor.Stage.SHOWING));
        show.setEnabled(begin.isEnabled()
                && chosen.filter(plan -> !plan.steps().isEmpty()).isPresent());
        setTarget.setEnabled(ready && chosen.isEmpty());
        size.setEnabled(ready && chosen.isEmpty());
        for (JComponent control : new JComponent[] {
            setEntry, best, bestOut, depth, insert, withdraw, toTarget, aim, sample, out, holdIn, holdOut
        }) {
            control.setEnabled(ready);
        }
        door.plan().ifPresent(plan -> depth.setMaximum((int) plan.needle().lengthMm()));
        showing = false;
        needleNow();
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
        String description = door.advice().isPresent() ? "" : plan.description() + " ";
        return description + "Done when: " + String.join("; ", plan.goals().words()) + ".";
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
        progress.setIndeterminate(door.stage() != RehearsalDoor.Stage.LOOKING);
        progress.setValue((int) (100 * door.share()));
    }

    private void studied() {
        Optional<TargetStudy> study = door.study();
        boolean there = study.isPresent();
        moves.say(
                door.stage() == RehearsalDoor.Stage.IMPOSSIBLE
                        ? door.doing()
                        : there
                                ? String.format(
                                        Locale.ROOT,
                                        "The target moves %.0f mm with the breath",
                                        study.get().map().motion().mostMm())
                                : "Looking how the target moves");
        double[] range = study.map(s -> s.map().motion().rangeMm()).orElse(new double[3]);
        moves3.say(
                there
                        ? String.format(
                                Locale.ROOT,
                                "%.0f up-down, %.0f front-back, %.0f sideways; %.0f mm wide",
                                range[2],
                                range[1],
                                range[0],
                                study.get().target().diameterMm())
                        : " ");
        if (there) {
            size.setValue((int) Math.round(study.get().target().diameterMm()));
            AccessMap map = study.get().map();
            java.util.Map<String, Object> c = map.counts();
            legend.show(percent(c, "free"), percent(c, "in_part"));
        } else {
            legend.show(-1, -1);
        }
    }

    private static long percent(java.util.Map<String, Object> counts, String key) {
        int reach = Math.max(1, (Integer) counts.get("in_reach"));
        return Math.round(100.0 * (Integer) counts.get(key) / reach);
    }

    private void advised() {
        Optional<PathAdvice> advice = door.advice();
        overBreath.setVisible(advice.isPresent());
        advice.ifPresent(a -> {
            StringBuilder rest = new StringBuilder(a.way());
            a.reasons().forEach(reason -> rest.append("\n").append(sentence(reason)));
            if (!a.margin().isEmpty()) {
                rest.append("\nMargin ").append(a.margin());
            }
            overBreath.say(a.level(), a.headline(), rest.toString());
        });
    }

    private static String sentence(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    /** What changes with every look. */
    private void needleNow() {
        Optional<NeedleState> state = door.state().filter(NeedleState::hasNeedle);
        now.setVisible(state.isPresent());
        boolean placed = state.filter(NeedleState::placed).isPresent();
        boolean ready = door.stage() == RehearsalDoor.Stage.READY;
        state.ifPresent(this::sayNow);
        depthText.setText(
                placed
                        ? String.format(
                                Locale.ROOT,
                                "Depth %.0f of %.0f mm",
                                state.get().depthMm(),
                                state.get().aimedMm())
                        : "Not in the body");
        miss.say(state.flatMap(NeedleState::miss).map(RehearsalDock::words).orElse("Tip to target: -"));
        if (!depth.getValueIsAdjusting()) {
            showing = true;
            depth.setValue((int) Math.round(state.map(NeedleState::depthMm).orElse(0.0)));
            showing = false;
        }
        aim.setEnabled(ready && placed);
        sample.setEnabled(ready && placed);
        out.setEnabled(ready && placed);
        withdraw.setEnabled(ready && placed);
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

    private void sayNow(NeedleState state) {
        if (!state.warnings().isEmpty()) {
            now.say(PathAdvice.Level.BARRED, "Now: " + String.join("; ", state.warnings()), "");
        } else if (!state.reasons().isEmpty()) {
            now.say(PathAdvice.Level.BARRED, "Now barred: " + String.join("; ", state.reasons()), "");
        } else {
            String margin = state.nearest().isEmpty()
                    ? "nothing near"
                    : String.format(Locale.ROOT, "%.1f mm from %s", state.marginMm(), state.nearest());
            PathAdvice.Level level = state.marginMm() < org.phrenic.rehearsal.Rehearsal.ROOM_MM
                    ? PathAdvice.Level.CAREFUL
                    : PathAdvice.Level.FREE;
            now.say(level, "Now free: " + margin, "");
        }
    }

    @Override
    public void onChange() {
        String preset = session.scenario().preset();
        quiet.setSelected(preset.equals("quiet"));
        deep.setSelected(preset.equals("deep"));
        if (!session.scenario().hold()
                && door.state().map(s -> s.waitsFor().isEmpty()).orElse(true)) {
            holdIn.setSelected(false);
            holdOut.setSelected(false);
        }
        BreathDock.shares(bar, session.scenario());
    }

    @Override
    public void onTick(Status status) {
        if (!isShowing()) {
            return;
        }
        History history = session.live().history();
        if (history != null && history.size() > 0) {
            bar.setPhase(history.values(history.size() - 1)[PHASE], PhaseColours.label(status.phaseLabel()));
        }
        needleNow();
    }

    /** What stands in the dock about the needle now, for tests and screen readers. */
    Verdict nowVerdict() {
        return now;
    }
}
