package org.phrenic.ui;

import java.awt.BorderLayout;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;

/** The docks about the view, arranged for a clinician or for a researcher, each place shown or put away. */
final class Docks {
    private final DockLayout layout;
    private final WindowPreferences preferences;
    private final Map<DockLayout.Place, JComponent> docks = new EnumMap<>(DockLayout.Place.class);
    private final JTabbedPane left = tabs("left");
    private final JTabbedPane right = tabs("right");
    private final JPanel bottom = new JPanel(new BorderLayout());
    private final OrgansDock organs;
    private final ShowDock show;
    private final ParameterDock parameters;
    private final BreathDock breath;
    private final ForcesDock forces;
    private final SettingsDock settings;
    private final PlotDock plots;
    private final TimelineDock timeline;

    Docks(Session session, Looks looks, DockLayout layout, WindowPreferences preferences) {
        this.layout = layout;
        this.preferences = preferences;
        organs = new OrgansDock(session, looks);
        show = new ShowDock(session, looks);
        parameters = new ParameterDock(session);
        breath = new BreathDock(session);
        forces = new ForcesDock(session);
        settings = new SettingsDock(session);
        plots = new PlotDock(session);
        timeline = new TimelineDock(session);
        docks.put(DockLayout.Place.LEFT, left);
        docks.put(DockLayout.Place.RIGHT, right);
        docks.put(DockLayout.Place.BOTTOM, bottom);
    }

    private static JTabbedPane tabs(String name) {
        JTabbedPane tabs = new JTabbedPane();
        tabs.setName("tabs." + name);
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        tabs.putClientProperty("JTabbedPane.tabAreaAlignment", "leading");
        tabs.setBorder(BorderFactory.createEmptyBorder());
        return tabs;
    }

    /** Arranges all docks; places that were put away stay so. */
    void arrange(Arrangement arrangement) {
        boolean research = arrangement == Arrangement.RESEARCHER;
        left.removeAll();
        left.addTab("Organs", null, DockBody.scroll(organs), "What is shown of the body, and how");
        right.removeAll();
        if (research) {
            left.addTab("Show", null, DockBody.scroll(show), "The model over the surfaces, colours, clip plane");
            right.addTab("Parameters", null, parameters, "Every number that can be tuned");
        }
        right.addTab("Breath", null, breath, "How it breathes");
        if (research) {
            right.addTab("Forces", null, forces, "Forces on and off one by one");
            right.addTab("Settings", null, settings, "Settings kept by name");
        }
        bottom.removeAll();
        bottom.add(timeline, BorderLayout.SOUTH);
        if (research) {
            bottom.add(plots, BorderLayout.CENTER);
        }
        for (DockLayout.Place place : DockLayout.Place.values()) {
            boolean shown = preferences.flag("shown." + place, true);
            layout.setFixed(place, place == DockLayout.Place.BOTTOM && !research);
            layout.put(place, shown ? docks.get(place) : null);
        }
    }

    /** Shows a place, or puts it away. */
    void toggle(DockLayout.Place place) {
        boolean shown = layout.component(place) == null;
        preferences.setFlag("shown." + place, shown);
        layout.put(place, shown ? docks.get(place) : null);
    }

    BreathDock breath() {
        return breath;
    }

    PlotDock plots() {
        return plots;
    }
}
