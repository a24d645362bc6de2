package org.phrenic.ui.dock;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.model.material.WallContact;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.Session;

/**
 * Switches of forces and parts of the model, as in the tables of Villard, Bourne and Bello 2009. Those that cannot
 * change while the scene runs reload it.
 */
public final class ForcesDock extends SessionDock {
    private static final List<Setting<?>> SWITCHES = List.of(
            Muscle.MUSCLE,
            TransdiaphragmaticPressure.PRESSURE,
            RibRotation.RIBS,
            RigidTendon.TENSEGRITY,
            WallContact.CONTACT,
            OrganSettings.LIVER);
    /** What the material of the paper lacks. */
    private static final Set<Setting<?>> PHYSICAL = Set.of(TransdiaphragmaticPressure.PRESSURE, WallContact.CONTACT);

    private static final List<Setting<?>> MODELS = List.of(OrganSettings.STERNUM, OrganSettings.LUNGS);

    private final transient Map<Setting<?>, JCheckBox> boxes = new LinkedHashMap<>();
    private final transient List<ChoiceRow> rows = new ArrayList<>();

    public ForcesDock(Session session) {
        super(session);
        JPanel switches = new JPanel(new MigLayout("insets 8 8 4 8, fillx, wrap 2", "[grow,fill,0::][]"));
        for (Setting<?> choice : SWITCHES) {
            JCheckBox box = new JCheckBox(choice.label());
            box.setToolTipText(SettingRow.tip(choice.description(), "key " + choice.key()));
            box.addActionListener(e -> change(choice, "" + !box.isSelected(), "" + box.isSelected()));
            boxes.put(choice, box);
            JLabel when = new JLabel(choice.isLive() ? "" : "reloads");
            when.setEnabled(false);
            switches.add(box);
            switches.add(when);
        }
        body.add(switches);
        for (Setting<?> choice : MODELS) {
            ChoiceRow row = new ChoiceRow(choice, choice.options(), (from, to) -> change(choice, from, to));
            row.setHint(choice.isLive() ? "" : "Another model reloads the scene.", false);
            rows.add(row);
            body.add(row);
        }
        follow();
    }

    private void change(Setting<?> choice, String from, String to) {
        EditName name = choice instanceof SwitchSetting
                ? EditName.of(choice.label() + (Boolean.parseBoolean(to) ? " on" : " off"))
                : new EditName(choice.label(), from, to);
        session.changeSeparately(name, List.of(Assignment.read("window", choice.key(), to)));
        if (!choice.isLive()) {
            session.note(name.text() + ": the scene is loaded again; the present one runs until then.");
        }
    }

    @Override
    public void onChange() {
        Scenario scenario = session.scenario();
        boolean physical = scenario.material().equals(Materials.PHYSICAL);
        boxes.forEach((choice, box) -> {
            boolean acts = physical || !PHYSICAL.contains(choice);
            box.setEnabled(acts);
            box.setSelected(acts && Boolean.parseBoolean(scenario.text(choice)));
        });
        rows.forEach(row -> row.show(scenario));
    }

    JCheckBox checkBox(Setting<?> choice) {
        return boxes.get(choice);
    }
}
