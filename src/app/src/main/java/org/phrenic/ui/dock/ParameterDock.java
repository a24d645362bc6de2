package org.phrenic.ui.dock;

import java.awt.BorderLayout;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.phrenic.file.BadInputException;
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
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;

/**
 * All parameters of the material, made from their declarations, in groups, with a search. Where the time step is beyond
 * the stability limit, the rows that can be the cause say so.
 */
public final class ParameterDock extends SessionDock {
    private static final int MAX_THREADS = 16;

    private final transient Map<Group, CollapsibleGroup> groups = new EnumMap<>(Group.class);
    private final transient List<SettingRow> stepLimitingRows = new ArrayList<>();
    private final JLabel nothingFound = new JLabel();
    private final JTextField search = Controls.describe(
            new JTextField(),
            "Search parameters",
            "Shows only rows whose name, key or meaning has these words; Escape clears");
    private String shownReason = "";

    public ParameterDock(Session session) {
        super(session);
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
                stepLimitingRows.add(row);
            }
        }
        add(toolBar(), BorderLayout.NORTH);
        follow();
    }

    private void addChoices() {
        CollapsibleGroup model = groups.get(Group.MODEL);
        model.addRow(new ChoiceRow(
                Materials.MATERIAL,
                Materials.MATERIAL.options(),
                (from, to) -> session.open(
                        new EditName(Materials.MATERIAL.label(), from, to),
                        session.userScenario().withMaterial(Materials.MATERIAL.named(to)))));
        model.addRow(choice(RunSettings.ANATOMY, RunSettings.VIRTUAL_BODIES));
        model.addRow(choice(OrganSettings.RESOLUTION, OrganSettings.RESOLUTION.options()));
        CollapsibleGroup numerics = groups.get(Group.NUMERICS);
        SliderRow step = new SliderRow(session, Numerics.TIME_STEP);
        numerics.addRow(step);
        ChoiceRow integrator = choice(Numerics.INTEGRATOR, Numerics.INTEGRATOR.options());
        numerics.addRow(integrator);
        int threads = Math.min(MAX_THREADS, Runtime.getRuntime().availableProcessors());
        numerics.addRow(choice(
                Numerics.THREADS,
                IntStream.rangeClosed(1, threads).mapToObj(Integer::toString).toList()));
        stepLimitingRows.add(step);
        stepLimitingRows.add(integrator);
    }

    private ChoiceRow choice(Setting<?> choice, List<String> options) {
        return new ChoiceRow(choice, options, (from, to) -> choose(choice, from, to));
    }

    private void choose(Setting<?> choice, String from, String to) {
        EditName change = new EditName(choice.label(), ChoiceRow.displayName(from), ChoiceRow.displayName(to));
        try {
            session.change(change, Assignment.read("window", choice.key(), to));
        } catch (BadInputException e) {
            // The folder of a body may be gone.
            session.refuse(e.getMessage());
            onChange();
        }
    }

    private JComponent toolBar() {
        JPanel tools = new JPanel(new MigLayout("insets 6 8 4 8, fillx", "[grow,fill][]"));
        search.putClientProperty("JTextField.placeholderText", "Search parameters");
        search.putClientProperty("JTextField.showClearButton", true);
        Controls.onEdit(search, this::onChange);
        search.registerKeyboardAction(
                e -> search.setText(""), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0), WHEN_FOCUSED);
        JButton reset = Controls.button(
                "Reset all", "Back to the defaults of material and breathing preset, in one change", this::resetAll);
        reset.setMnemonic('a');
        tools.add(search);
        tools.add(reset, "wrap");
        tools.add(nothingFound, "spanx, growx, wmin 0, hidemode 3");
        return tools;
    }

    /** Resets all parameters, time step and integrator in one change. */
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

    @Override
    public void onChange() {
        Scenario scenario = session.scenario();
        groups.values().forEach(group -> group.show(scenario, search.getText()));
        boolean found = rows().stream().anyMatch(r -> r.applies(scenario) && r.matches(search.getText()));
        nothingFound.setVisible(!found);
        nothingFound.setText(
                "<html>No parameter of the material '" + scenario.material().label()
                        + "' has this in its name, key or description." + inOtherMaterials(scenario) + "</html>");
        revalidate();
    }

    /** Labels of what the search finds among the parameters that the chosen material does not use. */
    private String inOtherMaterials(Scenario scenario) {
        String labels = rows().stream()
                .filter(r -> !r.applies(scenario) && r.matches(search.getText()))
                .map(SettingRow::label)
                .collect(Collectors.joining(", "));
        return labels.isEmpty() ? "" : " Other materials have " + labels + ".";
    }

    @Override
    public void onTick(RunStatus status) {
        String reason = substepText(status);
        if (!reason.equals(shownReason)) {
            shownReason = reason;
            Scenario scenario = session.scenario();
            stepLimitingRows.forEach(row -> {
                boolean cause = row.applies(scenario) && isCause(row, scenario);
                row.setHint(cause ? reason : "", true);
            });
        }
    }

    /** Why steps are split into substeps, in a short sentence; empty if they are not. */
    public static String substepText(RunStatus status) {
        return status.substepReason().map(ParameterDock::text).orElse("");
    }

    private static String text(SubstepReason reason) {
        String substeps = reason.substeps() > 1
                ? "Runs with " + reason.substeps() + " substeps"
                : "Sternum and cartilages make " + reason.sternumSubsteps() + " substeps";
        String step = substeps + ", because the time step " + NumberFormats.format(reason.dtS(), 3) + " s is ";
        return reason.cause().isEmpty()
                ? step + (reason.dtS() > reason.limitS() ? "beyond" : "too near to") + " the stability limit "
                        + NumberFormats.format(reason.limitS(), 3) + " s of " + reason.integrator() + " for this scene."
                : step + "too long for what the scene has become.";
    }

    /** Whether a row may ask for a smaller step: the time step itself, and those off their defaults. */
    private static boolean isCause(SettingRow row, Scenario scenario) {
        return row.isOffDefault(scenario) || row.isFor(Numerics.TIME_STEP.key());
    }

    List<SettingRow> rows() {
        return groups.values().stream().flatMap(g -> g.rows().stream()).toList();
    }

    JTextField search() {
        return search;
    }

    /** What a search says that finds no parameter. */
    JLabel nothingFound() {
        return nothingFound;
    }
}
