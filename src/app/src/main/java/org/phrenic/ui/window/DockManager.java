package org.phrenic.ui.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalListener;
import org.phrenic.ui.access.panel.AttemptsDock;
import org.phrenic.ui.access.panel.RehearsalDock;
import org.phrenic.ui.access.panel.SectionDock;
import org.phrenic.ui.chart.PlotDock;
import org.phrenic.ui.chart.TimelineDock;
import org.phrenic.ui.dock.BreathDock;
import org.phrenic.ui.dock.DisplayDock;
import org.phrenic.ui.dock.ForcesDock;
import org.phrenic.ui.dock.OrgansDock;
import org.phrenic.ui.dock.ParameterDock;
import org.phrenic.ui.dock.SettingsDock;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.ScrollablePanel;

/** The docks about the view, arranged for a clinician or for a researcher, each place shown or put away. */
public final class DockManager {
    private final DockLayout layout;
    private final WindowPreferences preferences;
    private final Map<DockLayout.Place, JComponent> docks = new EnumMap<>(DockLayout.Place.class);
    private final JTabbedPane left = tabbedPane("left");
    private final JTabbedPane right = tabbedPane("right");
    private final JPanel bottom = new JPanel(new BorderLayout());
    private final OrgansDock organs;
    private final DisplayDock display;
    private final ParameterDock parameters;
    private final BreathDock breath;
    private final ForcesDock forces;
    private final SettingsDock settings;
    private final PlotDock plots;
    private final TimelineDock timeline;
    private final RehearsalController rehearsalController;
    private final Session session;
    private final SceneViewport view;
    private RehearsalDock rehearsal;
    private AttemptsDock attempts;
    private SectionDock sections;

    DockManager(
            Session session,
            AppearanceModel looks,
            SceneViewport view,
            DockLayout layout,
            WindowPreferences preferences) {
        this.session = session;
        this.view = view;
        this.layout = layout;
        this.preferences = preferences;
        organs = new OrgansDock(session, looks);
        display = new DisplayDock(session, looks);
        parameters = new ParameterDock(session);
        breath = new BreathDock(session);
        forces = new ForcesDock(session);
        settings = new SettingsDock(session);
        plots = new PlotDock(session);
        timeline = new TimelineDock(session);
        rehearsalController = new RehearsalController(session, looks, view);
        docks.put(DockLayout.Place.LEFT, left);
        docks.put(DockLayout.Place.RIGHT, right);
        docks.put(DockLayout.Place.BOTTOM, bottom);
    }

    private static JTabbedPane tabbedPane(String name) {
        JTabbedPane tabs = new JTabbedPane();
        tabs.setName("tabs." + name);
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        tabs.putClientProperty("JTabbedPane.tabAreaAlignment", "leading");
        tabs.setBorder(BorderFactory.createEmptyBorder());
        return tabs;
    }

    /** Arranges all docks; places that were put away stay so. */
    void arrange(Workspace arrangement) {
        boolean research = arrangement == Workspace.RESEARCHER;
        left.removeAll();
        right.removeAll();
        bottom.removeAll();
        if (research) {
            rehearsalController.deactivate();
            left.addTab("Organs", null, ScrollablePanel.scrollPane(organs), "What is shown of the body, and how");
            left.addTab(
                    "Show",
                    null,
                    ScrollablePanel.scrollPane(display),
                    "The model over the surfaces, colours, clip plane");
            right.addTab("Parameters", null, parameters, "Every number that can be tuned");
            right.addTab("Breath", null, breath, "How it breathes");
            right.addTab("Forces", null, forces, "Forces on and off one by one");
            right.addTab("Settings", null, settings, "Settings kept by name");
            bottom.add(timeline, BorderLayout.SOUTH);
            bottom.add(plots, BorderLayout.CENTER);
        } else {
            createRehearsalDocks();
            left.addTab("Section", null, sections, "The body cut along the needle, and at its tip");
            left.addTab("Organs", null, ScrollablePanel.scrollPane(organs), "What is shown of the body, and how");
            right.addTab("Rehearse", null, rehearsal, "Exercise, breath, target, way in, needle");
            right.addTab("Report", null, attempts, "The report card and the attempts of this session");
            rehearsalController.open();
        }
        for (DockLayout.Place place : DockLayout.Place.values()) {
            boolean shown = preferences.flag("shown." + place, true);
            boolean filled = research || place != DockLayout.Place.BOTTOM;
            layout.setDock(place, shown && filled ? docks.get(place) : null);
        }
    }

    /** The clinician's docks, when they are first wanted. */
    private void createRehearsalDocks() {
        if (rehearsal != null) {
            return;
        }
        rehearsal = new RehearsalDock(session, rehearsalController, breath::selectPreset);
        attempts = new AttemptsDock(session, rehearsalController, view, null);
        sections = new SectionDock(rehearsalController);
        rehearsalController.addListener(new RehearsalListener() {
            @Override
            public void onAttemptEnded(Rehearsal rehearsal) {
                right.setSelectedIndex(right.indexOfComponent(attempts));
            }

            @Override
            public void onAttemptStarted() {
                right.setSelectedIndex(Math.max(0, right.indexOfComponent(rehearsal)));
            }
        });
    }

    /** Shows a place, or puts it away; an empty one stays so. */
    void toggle(DockLayout.Place place) {
        if (place == DockLayout.Place.BOTTOM && rehearsalController.isActive()) {
            return;
        }
        boolean shown = layout.dock(place) == null;
        preferences.setFlag("shown." + place, shown);
        layout.setDock(place, shown ? docks.get(place) : null);
    }

    /** All docks, wherever they stand. */
    List<Component> components() {
        return Stream.of(
                        left,
                        right,
                        bottom,
                        organs,
                        display,
                        parameters,
                        breath,
                        forces,
                        settings,
                        plots,
                        timeline,
                        rehearsal,
                        attempts,
                        sections)
                .filter(Objects::nonNull)
                .map(Component.class::cast)
                .toList();
    }

    public RehearsalController rehearsalController() {
        return rehearsalController;
    }

    /** The attempts of the session; null before the clinician's door was first opened. */
    public AttemptsDock attempts() {
        return attempts;
    }

    BreathDock breath() {
        return breath;
    }

    PlotDock plots() {
        return plots;
    }
}
