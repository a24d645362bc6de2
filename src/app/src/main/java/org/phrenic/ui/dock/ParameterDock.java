package org.phrenic.ui.dock;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
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
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SubstepReason;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.ScrollablePanel;

/**
 * All that can be tuned, made from the declarations of the parameters: rows that the present material uses, in groups,
 * with a search. Where the time step is beyond the stability limit, the rows that could mend it say so.
 */
public final class ParameterDock extends JPanel implements Session.Listener {
    private static final int MOST_OFFERED_THREADS = 16;

    private final transient Session session;
    private final transient Map<Group, CollapsibleGroup> groups = new EnumMap<>(Group.class);
    private final transient List<SettingRow> limiting = new ArrayList<>();
    private final JTextField search = new JTextField();
    private String limit = "";

    public ParameterDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        JPanel body = new ScrollablePanel();
        for (Group group : Group.values()) {
            CollapsibleGroup rows = new CollapsibleGroup(group.label());
            groups.put(group, rows);
            body.add(rows);
        }
        addChoices();
        for (Parameter parameter : Materials.parameters()) {
            SliderRow row = new SliderRow(session, parameter);
            groups.get(parameter.group()).addRow(row);
            if (parameter.limitsStep()) {
                limiting.add(row);
            }
        }
        add(tools(), BorderLayout.NORTH);
        add(ScrollablePanel.scrollPane(body), BorderLayout.CENTER);
        refresh();
        session.addListener(this);
    }

    private void addChoices() {
        CollapsibleGroup model = groups.get(Group.MODEL);
        model.addRow(new ChoiceRow(
                Materials.MATERIAL,
                Materials.MATERIAL.options(),
                s -> true,
                (from, to) -> session.open(
                        new EditName(Materials.MATERIAL.label(), from, to),
                        session.scenario().withMaterial(Materials.MATERIAL.named(to)))));
        model.addRow(choice(RunSettings.ANATOMY, RunSettings.ANATOMY.options()));
        model.addRow(choice(OrganSettings.RESOLUTION, OrganSettings.RESOLUTION.options()));
        CollapsibleGroup numerics = groups.get(Group.NUMERICS);
        SliderRow step = new SliderRow(session, Numerics.TIME_STEP);
        numerics.addRow(step);
        ChoiceRow integrator = choice(Numerics.INTEGRATOR, Numerics.INTEGRATOR.options());
        numerics.addRow(integrator);
        int threads = Math.min(MOST_OFFERED_THREADS, Runtime.getRuntime().availableProcessors());
        numerics.addRow(choice(
                Numerics.THREADS,
                IntStream.rangeClosed(1, threads).mapToObj(Integer::toString).toList()));
        limiting.add(step);
        limiting.add(integrator);
    }

    private ChoiceRow choice(Setting<?> choice, List<String> options) {
        return new ChoiceRow(
                choice,
                options,
                s -> true,
                (from, to) -> session.change(
                        new EditName(choice.label(), ChoiceRow.displayName(from), ChoiceRow.displayName(to)),
                        Assignment.read("window", choice.key(), to)));
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
        List<Setting<?>> settings = new ArrayList<>(scenario.material().parameters());
        settings.add(Numerics.TIME_STEP);
        settings.add(Numerics.INTEGRATOR);
        for (Setting<?> setting : settings) {
            if (!scenario.get(setting).equals(scenario.defaultOf(setting))) {
                list.add(new Assignment("window", setting, scenario.defaultOf(setting)));
            }
        }
        if (!list.isEmpty()) {
            session.changeSeparately(EditName.of("Reset of all parameters"), list);
        }
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
    public void onTick(RunStatus status) {
        String now = substepText(status);
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

    /** Why steps are split into substeps, in a short sentence; empty if they are not. */
    public static String substepText(RunStatus status) {
        return status.substepReason().map(ParameterDock::text).orElse("");
    }

    private static String text(SubstepReason reason) {
        String step = "Runs with " + reason.substeps() + " substeps, because the time step "
                + NumberFormats.format(reason.dtS(), 3) + " s is ";
        return reason.cause().isEmpty()
                ? step + "beyond the stability limit " + NumberFormats.format(reason.limitS(), 3) + " s of "
                        + reason.integrator() + " for this scene."
                : step + "too long for what the scene has become.";
    }

    /**
     * Whether a row was moved to where it asks for a smaller step: the step itself always, the others when they are off
     * their defaults.
     */
    private static boolean isCause(SettingRow row, Scenario scenario) {
        return row.isOffDefault(scenario) || row.isFor(Numerics.TIME_STEP.key());
    }

    /** Rows by their order, for tests. */
    List<SettingRow> rows() {
        return groups.values().stream().flatMap(g -> g.rows().stream()).toList();
    }

    JTextField search() {
        return search;
    }
}
