package org.phrenic.ui;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Choice;
import org.phrenic.simulation.Material;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/**
 * All that can be tuned, made from the tables {@link Parameter} and {@link Choice}: rows that the present material uses, in groups, with a search. Where the time step is beyond the stability limit, the rows
 * that could mend it say so.
 */
public final class ParameterDock extends JPanel implements Session.Events {
    private static final int MOST_OFFERED_THREADS = 16;
    private static final Pattern NUMBER = Pattern.compile("\\d+\\.\\d+(e-?\\d+)?");

    private final transient Session session;
    private final transient Map<ParameterGroup, RowGroup> groups = new EnumMap<>(ParameterGroup.class);
    private final transient List<SettingRow> limiting = new ArrayList<>();
    private final JTextField search = new JTextField();
    private String limit = "";

    public ParameterDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        JPanel body = new DockBody();
        for (ParameterGroup group : ParameterGroup.values()) {
            RowGroup rows = new RowGroup(group.label());
            groups.put(group, rows);
            body.add(rows);
        }
        addChoices();
        for (Parameter parameter : Parameter.values()) {
            ValueRow row = ValueRow.of(session, parameter);
            groups.get(ParameterGroup.of(parameter)).addRow(row);
            if (ParameterGroup.limitsStep(parameter)) {
                limiting.add(row);
            }
        }
        add(tools(), BorderLayout.NORTH);
        add(DockBody.scroll(body), BorderLayout.CENTER);
        refresh();
        session.listen(this);
    }

    private void addChoices() {
        RowGroup model = groups.get(ParameterGroup.MODEL);
        model.addRow(new ChoiceRow(
                Choice.MATERIAL,
                Choice.MATERIAL.options(),
                s -> true,
                (from, to) -> session.open(
                        Settings.changeName(Choice.MATERIAL.label(), from, to),
                        Settings.ofMaterial(session.scenario(), Material.valueOf(to.toUpperCase(Locale.ROOT))))));
        model.addRow(choice(Choice.ANATOMY, Choice.ANATOMY.options()));
        model.addRow(choice(Choice.RESOLUTION, Choice.RESOLUTION.options()));
        RowGroup numerics = groups.get(ParameterGroup.NUMERICS);
        ValueRow step = ValueRow.of(session, Choice.TIME_STEP, ParameterDock::defaultStep);
        numerics.addRow(step);
        ChoiceRow integrator = choice(Choice.INTEGRATOR, Choice.INTEGRATOR.options());
        numerics.addRow(integrator);
        int threads = Math.min(MOST_OFFERED_THREADS, Runtime.getRuntime().availableProcessors());
        numerics.addRow(choice(
                Choice.THREADS,
                IntStream.rangeClosed(1, threads).mapToObj(Integer::toString).toList()));
        limiting.add(step);
        limiting.add(integrator);
    }

    private ChoiceRow choice(Choice choice, List<String> options) {
        return new ChoiceRow(
                choice,
                options,
                s -> true,
                (from, to) -> session.change(
                        Settings.changeName(choice.label(), ChoiceRow.nameOf(from), ChoiceRow.nameOf(to)),
                        new Assignment("window", choice.key(), to)));
    }

    /** Step of the material, s. */
    private static double defaultStep(Scenario scenario) {
        return Scenario.defaults()
                .with("material=" + scenario.material().label())
                .timeStepS();
    }

    private JComponent tools() {
        JPanel tools = new JPanel(new MigLayout("insets 6 8 4 8, fillx", "[grow,fill][]"));
        search.putClientProperty("JTextField.placeholderText", "Search parameters");
        search.putClientProperty("JTextField.showClearButton", true);
        search.setToolTipText("Shows only rows whose name, key or meaning has these words; Escape clears");
        search.getAccessibleContext().setAccessibleName("Search parameters");
        search.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                refresh();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                refresh();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                refresh();
            }
        });
        search.getInputMap().put(KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0), "clear");
        search.getActionMap().put("clear", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                search.setText("");
            }
        });
        JButton reset = new JButton("Reset all");
        reset.setToolTipText("Back to the defaults of material and breathing preset, in one change");
        reset.setMnemonic('a');
        reset.addActionListener(e -> resetAll());
        tools.add(search);
        tools.add(reset);
        return tools;
    }

    /** All numbers, time step and integrator back to their defaults; one change to undo. */
    void resetAll() {
        Scenario scenario = session.scenario();
        List<Assignment> list = new ArrayList<>();
        for (Parameter parameter : Parameter.values()) {
            double standard = Settings.defaultOf(scenario, parameter);
            if (parameter.isUsedBy(scenario.material()) && Settings.value(scenario, parameter) != standard) {
                list.add(Settings.assignment(parameter, standard));
            }
        }
        if (scenario.timeStepS() != defaultStep(scenario)) {
            list.add(new Assignment("window", Choice.TIME_STEP.key(), Settings.plain(defaultStep(scenario))));
        }
        IntegratorKind integrator = scenario.material().integrator();
        if (scenario.integrator() != integrator) {
            list.add(new Assignment("window", Choice.INTEGRATOR.key(), integrator.label()));
        }
        session.edits().close();
        if (!list.isEmpty()) {
            session.change("Reset of all parameters", list.toArray(Assignment[]::new));
        }
        session.edits().close();
    }

    private void refresh() {
        groups.values().forEach(group -> group.show(session.scenario(), search.getText()));
        revalidate();
    }

    @Override
    public void onScene(LiveScene scene) {
        refresh();
    }

    @Override
    public void onChange() {
        refresh();
    }

    @Override
    public void onTick(Status status) {
        String now = limitInWords(status);
        if (!now.equals(limit)) {
            limit = now;
            Scenario scenario = session.scenario();
            limiting.forEach(row -> row.hint(SettingRow.Hint.NOTE, ""));
            limiting.stream()
                    .filter(row -> row.applies(scenario))
                    .filter(row -> !now.isEmpty() && isCause(row, scenario))
                    .forEach(row -> row.hint(SettingRow.Hint.WARNING, now));
        }
    }

    /** The sentence of the limit as it fits below a row: what is done, and why; no more digits than somebody reads. */
    static String limitInWords(Status status) {
        if (status.limitSentence().isEmpty()) {
            return "";
        }
        String why = status.limitSentence().replaceFirst(": split into.*$", "").replaceFirst(" \\([^)]*\\)$", "");
        why = NUMBER.matcher(why).replaceAll(found -> Figures.text(Double.parseDouble(found.group()), 3));
        return "Runs with " + status.substeps() + " substeps, because the " + why + ".";
    }

    /** Whether a row was moved to where it asks for a smaller step: the step itself always, the others when they are off their defaults. */
    private static boolean isCause(SettingRow row, Scenario scenario) {
        return row.isOffDefault(scenario) || row.isFor(Choice.TIME_STEP.key());
    }

    /** Rows by their order, for tests. */
    List<SettingRow> rows() {
        return groups.values().stream().flatMap(g -> g.rows().stream()).toList();
    }

    JTextField search() {
        return search;
    }
}
