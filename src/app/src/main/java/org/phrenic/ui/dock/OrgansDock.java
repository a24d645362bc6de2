package org.phrenic.ui.dock;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JColorChooser;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.phrenic.scene.style.Appearance;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.AppearanceModel.Property;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.ScrollablePanel;
import org.phrenic.ui.widget.Swatch;
import org.phrenic.ui.widget.Theme;

/** A row for each group of organs: visibility, colour, opacity, surface or wireframe. */
public final class OrgansDock extends ScrollablePanel implements Session.Listener {
    private static final int PERCENT = 100;
    private static final int OPACITY_WIDTH = 72;
    private static final int LEAST_OPACITY_WIDTH = 36;
    private static final int LABEL_WIDTH = 70;
    private static final int SWATCH_SIZE = 14;

    private record GroupRow(AppearanceModel.Group group, JCheckBox visible, JSlider opacity, JToggleButton wire) {}

    private final transient AppearanceModel appearance;
    private final transient List<GroupRow> rows = new ArrayList<>();
    private transient List<AppearanceModel.Group> shownGroups = List.of();
    private boolean updating;

    public OrgansDock(Session session, AppearanceModel appearance) {
        super(new MigLayout("insets 6 8 6 8, gap 0 2, wrap 1, fillx, novisualpadding", "[grow, fill]", ""));
        this.appearance = appearance;
        setName("organs");
        session.addListener(this);
        appearance.addListener(this::refresh);
    }

    @Override
    public void onScene(LiveScene scene) {
        if (shownGroups.equals(appearance.groups())) {
            return;
        }
        shownGroups = appearance.groups();
        removeAll();
        rows.clear();
        shownGroups.forEach(this::addRow);
        JButton reset = Controls.button("As in an atlas", "The default appearance of all organs", appearance::reset);
        add(reset, "gaptop 6, growx 0, alignx left");
        refresh();
        revalidate();
        repaint();
    }

    private void addRow(AppearanceModel.Group group) {
        String label = group.label();
        JCheckBox visible = Controls.describe(new JCheckBox(label), label + " visible", "Show or hide: " + label);
        visible.addActionListener(e -> {
            boolean shown = visible.isSelected();
            change(group, Property.VISIBILITY, look -> look.withVisible(shown));
        });
        JButton colour = Controls.iconButton(swatch(group), label + " colour", () -> pickColour(group));
        colour.setToolTipText("Colour of: " + label);
        JSlider opacity = Controls.describe(
                Controls.slider(0, PERCENT, PERCENT), label + " opacity", "Opacity in percent: " + label);
        opacity.addChangeListener(e -> {
            if (!updating) {
                float share = opacity.getValue() / (float) PERCENT;
                change(group, Property.OPACITY, look -> look.withOpacity(share));
            }
        });
        JToggleButton wire = Controls.flat(new JToggleButton(Icons.MESH));
        Controls.describe(wire, label + " wireframe", "Surface or wireframe: " + label);
        wire.addActionListener(e -> {
            boolean edges = wire.isSelected();
            change(group, Property.WIREFRAME, look -> look.withWireframe(edges));
        });
        String columns = "[" + LABEL_WIDTH + "::, grow, fill][][" + LEAST_OPACITY_WIDTH + ":" + OPACITY_WIDTH + "][]";
        JPanel row = new JPanel(new MigLayout("insets 0, gap 4, novisualpadding", columns, "[center]"));
        row.add(visible, "w 0:" + LABEL_WIDTH + ":");
        row.add(colour);
        row.add(opacity, "growx, wmin 0");
        row.add(wire);
        rows.add(new GroupRow(group, visible, opacity, wire));
        add(row, "wmin 0");
    }

    private void change(AppearanceModel.Group group, Property property, UnaryOperator<Appearance> change) {
        if (!updating) {
            appearance.changeGroup(group, property, change);
        }
    }

    private void pickColour(AppearanceModel.Group group) {
        Color picked = JColorChooser.showDialog(this, "Colour of " + group.label(), colour(group), false);
        if (picked != null) {
            float[] rgb = picked.getRGBColorComponents(null);
            change(group, Property.COLOUR, look -> look.withRgb(rgb));
        }
    }

    private Color colour(AppearanceModel.Group group) {
        return appearance
                .appearance(group)
                .map(look -> new Color(look.packedRgb()))
                .orElse(Color.GRAY);
    }

    private void refresh() {
        updating = true;
        for (GroupRow row : rows) {
            appearance.appearance(row.group()).ifPresent(look -> {
                row.visible().setSelected(look.visible());
                row.opacity().setValue(Math.round(look.opacity() * PERCENT));
                row.wire().setSelected(look.wireframe());
            });
        }
        updating = false;
        repaint();
    }

    private Swatch swatch(AppearanceModel.Group group) {
        return new Swatch(SWATCH_SIZE, SWATCH_SIZE, g -> {
            g.setColor(colour(group));
            g.fillRoundRect(0, 0, SWATCH_SIZE - 1, SWATCH_SIZE - 1, 5, 5);
            g.setColor(Theme.BORDER);
            g.drawRoundRect(0, 0, SWATCH_SIZE - 1, SWATCH_SIZE - 1, 5, 5);
        });
    }
}
