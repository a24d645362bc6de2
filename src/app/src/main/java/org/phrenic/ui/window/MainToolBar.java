package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.SwingUtilities;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.ui.session.PlaybackSpeed;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.ListKeys;
import org.phrenic.ui.widget.RowsLayout;
import org.phrenic.ui.widget.Theme;

/** The tool bar: run, breathing, view, workspace. */
final class MainToolBar extends JToolBar {
    /** Shown where the camera has none of the standard views; not among those that can be chosen. */
    private static final String TURNED = "Turned";

    private static final int ROW_GAP = 3;

    private final JButton play;
    private final JToggleButton hold;
    private final JToggleButton quiet;
    private final JToggleButton deep;
    private final JComboBox<String> views = ListKeys.chooseByEnter(new JComboBox<>());
    private boolean updating;
    private final Map<Workspace, JToggleButton> workspaceButtons = new EnumMap<>(Workspace.class);
    private final transient MenuActions actions;
    private final SceneViewport view;

    MainToolBar(MenuActions actions, Session session, SceneViewport view, Consumer<Workspace> showWorkspace) {
        this.actions = actions;
        this.view = view;
        setFloatable(false);
        setLayout(new RowsLayout(ROW_GAP));
        setName("toolbar");
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.BORDER),
                BorderFactory.createEmptyBorder(3, 8, 3, 8)));
        play = addIconButton(actions.play);
        addIconButton(actions.step);
        addIconButton(actions.reset);
        addGap();
        JComboBox<PlaybackSpeed> speed = ListKeys.chooseByEnter(new JComboBox<>(PlaybackSpeed.values()));
        speed.setSelectedItem(PlaybackSpeed.REAL);
        speed.addActionListener(e -> session.setSpeed(((PlaybackSpeed) speed.getSelectedItem()).factor()));
        addBox(speed, "Speed", "Simulated time over real time");
        addGroupSeparator();
        quiet = addTextButton(actions.quiet, session);
        deep = addTextButton(actions.deep, session);
        hold = addTextButton(actions.hold, session);
        addGroupSeparator();
        addViews();
        addGap();
        addIconButton(actions.picture);
        add(Box.createHorizontalGlue());
        for (Workspace workspace : Workspace.values()) {
            String label = workspace.label();
            JToggleButton button = Controls.highlightWhenSelected(new JToggleButton(label));
            Controls.describe(button, "Arrange for: " + label, "Arrange the window for this: " + label);
            button.setName("toolbar." + label);
            button.addActionListener(e -> showWorkspace.accept(workspace));
            workspaceButtons.put(workspace, button);
            add(button);
        }
        addGroupSeparator();
        addIconButton(actions.theme);
    }

    /** The standard views, of which the box shows the one that the camera has. */
    private void addViews() {
        // The actions of the views come first, in the order of AnatomicalView.
        actions.views.stream()
                .limit(AnatomicalView.values().length)
                .map(MenuAction::name)
                .forEach(views::addItem);
        views.setRenderer(Controls.renderer(name -> name == null ? TURNED : name.toString()));
        views.addActionListener(e -> {
            if (!updating && views.getSelectedIndex() >= 0) {
                actions.views.get(views.getSelectedIndex()).run();
            }
        });
        addBox(views, "View", "From where to look");
        view.setCameraListener(() -> showView(view.camera()));
        showView(view.camera());
    }

    private void showView(Camera camera) {
        updating = true;
        views.setSelectedIndex(camera.view().map(Enum::ordinal).orElse(-1));
        updating = false;
    }

    private JButton addIconButton(MenuAction action) {
        JButton button = new JButton(action);
        button.setHideActionText(true);
        return addButton(button, action);
    }

    /** A button that shows a state: a press asks for it, and whether it is there is shown by {@link #refresh}. */
    private JToggleButton addTextButton(MenuAction action, Session session) {
        JToggleButton button = new JToggleButton(action.name());
        button.addActionListener(e -> {
            action.actionPerformed(e);
            refresh(session);
        });
        return addButton(button, action);
    }

    private <B extends AbstractButton> B addButton(B button, MenuAction action) {
        String key = action.acceleratorText();
        Controls.describe(button, action.name(), action.tip() + (key.isEmpty() ? "" : " (" + key + ")"));
        button.setName("toolbar." + action.name());
        button.setFocusable(true);
        // The mouse leaves the focus, and with it the keys, to the view.
        button.setRequestFocusEnabled(false);
        add(button);
        return button;
    }

    private void addBox(JComboBox<?> box, String name, String tip) {
        Controls.describe(box, name, tip);
        Controls.onListClosed(box, view::requestFocusInWindow);
        box.setMaximumSize(box.getPreferredSize());
        add(box);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean otherWidth = width != getWidth();
        super.setBounds(x, y, width, height);
        if (otherWidth) {
            // The height that is asked for may be another.
            SwingUtilities.invokeLater(this::revalidate);
        }
    }

    private void addGap() {
        add(Box.createRigidArea(UIScale.scale(new Dimension(8, 0))));
    }

    private void addGroupSeparator() {
        addSeparator(UIScale.scale(new Dimension(17, 22)));
    }

    void setWorkspace(Workspace shown) {
        workspaceButtons.forEach((workspace, button) -> button.setSelected(workspace == shown));
    }

    void refresh(Session session) {
        boolean playing = session.live().isPlaying();
        play.setIcon(playing ? Icons.PAUSE : Icons.PLAY);
        play.getAccessibleContext().setAccessibleName(playing ? "Pause" : "Play");
        boolean preset = session.scenario().trace().isEmpty();
        quiet.setSelected(preset && session.scenario().preset().equals("quiet"));
        deep.setSelected(preset && session.scenario().preset().equals("deep"));
        refreshHold();
    }

    /** Shows whether the breath is held, or will be. */
    void refreshHold() {
        hold.setSelected(actions.isBreathHeld());
    }
}
