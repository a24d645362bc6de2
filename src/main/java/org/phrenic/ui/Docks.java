package org.phrenic.ui;

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
import org.phrenic.rehearsal.Rehearsal;

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
    private final RehearsalDoor door;
    private final Session session;
    private final SceneView view;
    private RehearsalDock rehearse;
    private AttemptsDock attempts;
    private SectionDock sections;

    Docks(Session session, Looks looks, SceneView view, DockLayout layout, WindowPreferences preferences) {
        this.session = session;
        this.view = view;
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
        door = new RehearsalDoor(session, looks, view);
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
        right.removeAll();
        bottom.removeAll();
        if (research) {
            door.close();
            left.addTab("Organs", null, DockBody.scroll(organs), "What is shown of the body, and how");
            left.addTab("Show", null, DockBody.scroll(show), "The model over the surfaces, colours, clip plane");
            right.addTab("Parameters", null, parameters, "Every number that can be tuned");
            right.addTab("Breath", null, breath, "How it breathes");
            right.addTab("Forces", null, forces, "Forces on and off one by one");
            right.addTab("Settings", null, settings, "Settings kept by name");
            bottom.add(timeline, BorderLayout.SOUTH);
            bottom.add(plots, BorderLayout.CENTER);
        } else {
            makeClinic();
            left.addTab("Section", null, sections, "The body cut along the needle, and at its tip");
            left.addTab("Organs", null, DockBody.scroll(organs), "What is shown of the body, and how");
            right.addTab("Rehearse", null, rehearse, "Exercise, breath, target, way in, needle");
            right.addTab("Report", null, attempts, "The report card and the attempts of this session");
            door.open();
        }
        for (DockLayout.Place place : DockLayout.Place.values()) {
            boolean shown = preferences.flag("shown." + place, true);
            boolean filled = research || place != DockLayout.Place.BOTTOM;
            layout.put(place, shown && filled ? docks.get(place) : null);
        }
    }

    /** The clinician's docks, when they are first wanted. */
    private void makeClinic() {
        if (rehearse != null) {
            return;
        }
        rehearse = new RehearsalDock(session, door, breath::choose);
        attempts = new AttemptsDock(session, door, view, null);
        sections = new SectionDock(door);
        door.listen(new DoorEvents() {
            @Override
            public void onAttempt(Rehearsal rehearsal) {
                right.setSelectedIndex(right.indexOfComponent(attempts));
            }

            @Override
            public void onBegin() {
                right.setSelectedIndex(Math.max(0, right.indexOfComponent(rehearse)));
            }
        });
    }

    /** Shows a place, or puts it away; an empty one stays so. */
    void toggle(DockLayout.Place place) {
        if (place == DockLayout.Place.BOTTOM && door.isOpen()) {
            return;
        }
        boolean shown = layout.component(place) == null;
        preferences.setFlag("shown." + place, shown);
        layout.put(place, shown ? docks.get(place) : null);
    }

    /** All docks, wherever they stand. */
    List<Component> all() {
        return Stream.of(
                        left,
                        right,
                        bottom,
                        organs,
                        show,
                        parameters,
                        breath,
                        forces,
                        settings,
                        plots,
                        timeline,
                        rehearse,
                        attempts,
                        sections)
                .filter(Objects::nonNull)
                .map(Component.class::cast)
                .toList();
    }

    RehearsalDoor door() {
        return door;
    }

    /** The attempts of the session; null before the clinician's door was first opened. */
    AttemptsDock attempts() {
        return attempts;
    }

    BreathDock breath() {
        return breath;
    }

    PlotDock plots() {
        return plots;
    }
}
