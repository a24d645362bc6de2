package org.phrenic.ui.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.access.AttemptHistory;
import org.phrenic.ui.access.AttemptReportWriter;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.access.panel.AttemptsDock;
import org.phrenic.ui.access.panel.FluoroscopyDock;
import org.phrenic.ui.access.panel.RehearsalDock;
import org.phrenic.ui.access.panel.SectionDock;
import org.phrenic.ui.access.panel.UltrasoundDock;
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

/** The docks around the view and their arrangement in each workspace. */
public final class DockManager {
    private final DockLayout layout;
    private final WindowPreferences preferences;
    private final JTabbedPane left = tabbedPane("left");
    private final JTabbedPane right = tabbedPane("right");
    private final JPanel bottom = new JPanel(new BorderLayout());
    private final Map<DockLayout.Place, JComponent> docks =
            Map.of(DockLayout.Place.LEFT, left, DockLayout.Place.RIGHT, right, DockLayout.Place.BOTTOM, bottom);
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
    private Optional<AttemptHistory> history = Optional.empty();
    private RehearsalDock rehearsal;
    private AttemptsDock attempts;
    private SectionDock sections;
    private UltrasoundDock ultrasound;
    private FluoroscopyDock xray;

    DockManager(
            Session session,
            AppearanceModel appearance,
            SceneViewport view,
            DockLayout layout,
            WindowPreferences preferences) {
        this.session = session;
        this.view = view;
        this.layout = layout;
        this.preferences = preferences;
        organs = new OrgansDock(session, appearance);
        display = new DisplayDock(session, appearance);
        parameters = new ParameterDock(session);
        breath = new BreathDock(session);
        forces = new ForcesDock(session);
        plots = new PlotDock(session);
        settings = new SettingsDock(session, plots);
        timeline = new TimelineDock(session);
        rehearsalController = new RehearsalController(session, appearance, view);
        leaveKeysToView(left);
        leaveKeysToView(right);
    }

    /** A click on a tab gives the keys that the former tab had to the view, not to the first control of the new one. */
    private void leaveKeysToView(JTabbedPane tabs) {
        tabs.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                Component owner =
                        KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
                boolean focused = owner != null && SwingUtilities.isDescendingFrom(owner, tabs);
                if (focused && tabs.indexAtLocation(e.getX(), e.getY()) >= 0) {
                    // After the tabs have given it to the new one.
                    SwingUtilities.invokeLater(view::requestFocusInWindow);
                }
            }
        });
    }

    private static JTabbedPane tabbedPane(String name) {
        JTabbedPane tabs = new JTabbedPane();
        tabs.setName("tabs." + name);
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        tabs.putClientProperty("JTabbedPane.tabAreaAlignment", "leading");
        tabs.setBorder(BorderFactory.createEmptyBorder());
        // The mouse leaves the focus, and with it the keys, where they are.
        tabs.setRequestFocusEnabled(false);
        return tabs;
    }

    /** Arranges the docks of a workspace; hidden places stay hidden. */
    void arrange(Workspace workspace) {
        boolean research = workspace == Workspace.RESEARCHER;
        layout.useSizesOf(workspace);
        left.removeAll();
        right.removeAll();
        bottom.removeAll();
        if (research) {
            rehearsalController.deactivate();
            addOrgans();
            JComponent show = ScrollablePanel.scrollPane(display);
            left.addTab("Show", null, show, "The model over the surfaces, colours, clip plane");
            right.addTab("Parameters", null, parameters, "Every number that can be tuned");
            right.addTab("Breath", null, breath, "Breathing pattern");
            right.addTab("Forces", null, forces, "Forces on and off one by one");
            right.addTab("Settings", null, settings, "Settings stored by name");
            bottom.add(timeline, BorderLayout.SOUTH);
            bottom.add(plots, BorderLayout.CENTER);
        } else {
            createRehearsalDocks();
            left.addTab("Ultrasound", null, ultrasound, "The live image of the probe, and its controls");
            left.addTab("X-ray", null, xray, "The picture of a C-arm, and its angles");
            left.addTab("Section", null, sections, "The body cut along the needle, and at its tip");
            addOrgans();
            right.addTab("Rehearse", null, rehearsal, "Exercise, breath, target, entry, needle");
            right.addTab("Report", null, attempts, "The report card and the attempts of this session");
            rehearsalController.activate();
        }
        for (DockLayout.Place place : DockLayout.Place.values()) {
            boolean shown = preferences.flag("shown." + place, true);
            boolean filled = research || place != DockLayout.Place.BOTTOM;
            layout.setDock(place, shown && filled ? docks.get(place) : null);
        }
        layout.endChange();
    }

    /** Keeps the attempts of rehearsals over sessions. */
    void keepAttempts(AttemptHistory kept) {
        history = Optional.of(kept);
        if (attempts != null) {
            attempts.keepIn(kept);
        }
    }

    /** Writes the attempts that wait; asks whether to try again where that fails. */
    void writeAttempts(Predicate<String> again) {
        history.ifPresent(attempted -> attempted.writeWaiting(again));
    }

    private void addOrgans() {
        left.addTab("Organs", null, ScrollablePanel.scrollPane(organs), "What is shown of the body, and how");
    }

    /** Breathes by a preset. A breath of it that is held in a rehearsal goes on, as a step of the attempt. */
    void selectPreset(String preset) {
        Scenario scenario = session.scenario();
        boolean goesOn = rehearsalController.stage() == RehearsalStage.READY
                && scenario.hold()
                && BreathDock.isBreathOf(scenario, preset);
        if (goesOn) {
            rehearsalController.needle().hold(Optional.empty());
        } else if (BreathDock.isBreathOf(scenario, preset)) {
            breath.selectPreset(preset);
        } else {
            rehearsalController.needle().unlessInBody("Another breath", () -> breath.selectPreset(preset));
        }
    }

    /** Makes the clinician's docks at their first use. */
    private void createRehearsalDocks() {
        if (rehearsal != null) {
            return;
        }
        rehearsal = new RehearsalDock(session, rehearsalController, this::selectPreset);
        attempts = new AttemptsDock(session, rehearsalController, new AttemptReportWriter(view), null);
        history.ifPresent(attempts::keepIn);
        sections = new SectionDock(rehearsalController);
        ultrasound = new UltrasoundDock(session, rehearsalController);
        xray = new FluoroscopyDock(session, rehearsalController);
        rehearsalController.addListener(new RehearsalController.Listener() {
            @Override
            public void onAttemptEnded(Rehearsal report) {
                select(attempts);
            }

            @Override
            public void onAttemptStarted() {
                select(rehearsal);
            }
        });
    }

    /** Selects a dock at the right, if it is there: a report may come after another workspace. */
    private void select(Component dock) {
        int at = right.indexOfComponent(dock);
        if (at >= 0) {
            right.setSelectedIndex(at);
        }
    }

    /** Shows or hides a place; one without docks stays hidden. */
    void toggle(DockLayout.Place place) {
        if (place == DockLayout.Place.BOTTOM && rehearsalController.isActive()) {
            return;
        }
        boolean shown = layout.dock(place) == null;
        preferences.setFlag("shown." + place, shown);
        layout.setDock(place, shown ? docks.get(place) : null);
    }

    boolean isShown(DockLayout.Place place) {
        return layout.dock(place) != null;
    }

    /** All docks, shown or not. */
    List<Component> components() {
        List<Component> all = new ArrayList<>(
                List.of(left, right, bottom, organs, display, parameters, breath, forces, settings, plots, timeline));
        if (rehearsal != null) {
            all.addAll(List.of(rehearsal, attempts, sections, ultrasound, xray));
        }
        return all;
    }

    public RehearsalController rehearsalController() {
        return rehearsalController;
    }

    /** The attempts of the session; null before the clinician's workspace is first shown. */
    public AttemptsDock attempts() {
        return attempts;
    }

    PlotDock plots() {
        return plots;
    }
}
