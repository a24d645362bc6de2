package org.phrenic.ui.window;

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
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.ui.dock.BreathDock;
import org.phrenic.ui.session.PlaybackSpeed;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/** The buttons at the top: run, breathe, look. */
final class MainToolBar extends JToolBar {
    private static final AnatomicalView[] VIEWS = {
        AnatomicalView.ANTERIOR,
        AnatomicalView.POSTERIOR,
        AnatomicalView.LEFT,
        AnatomicalView.RIGHT,
        AnatomicalView.SUPERIOR,
        AnatomicalView.INFERIOR
    };
    private static final String[] VIEW_NAMES = {
        "From the front", "From behind", "From the left", "From the right", "From above", "From below"
    };

    private final JButton play;
    private final JToggleButton hold;
    private final JToggleButton quiet;
    private final JToggleButton deep;
    private final JComboBox<PlaybackSpeed> speed = new JComboBox<>(PlaybackSpeed.values());

    private final Map<Workspace, JToggleButton> workspaceButtons = new EnumMap<>(Workspace.class);

    /** @param enter told for whom the window is to be arranged */
    MainToolBar(MenuActions commands, Session session, SceneViewport view, Consumer<Workspace> enter) {
        setFloatable(false);
        setName("toolbar");
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.borderColour()),
                BorderFactory.createEmptyBorder(3, 8, 3, 8)));
        play = iconButton(new JButton(), commands.play);
        iconButton(new JButton(), commands.step);
        iconButton(new JButton(), commands.reset);
        addGap();
        speed.setSelectedItem(PlaybackSpeed.REAL);
        speed.setToolTipText("How fast simulated time may go against real time");
        speed.getAccessibleContext().setAccessibleName("Speed");
        speed.addActionListener(e -> session.setSpeed(((PlaybackSpeed) speed.getSelectedItem()).factor()));
        addFixedSize(speed);
        addGroupSeparator();
        quiet = textButton(commands.quiet);
        deep = textButton(commands.deep);
        hold = textButton(commands.hold);
        addGroupSeparator();
        JComboBox<String> views = new JComboBox<>(VIEW_NAMES);
        views.setToolTipText("From where to look");
        views.getAccessibleContext().setAccessibleName("View");
        views.addActionListener(e -> view.setCamera(view.camera().withView(VIEWS[views.getSelectedIndex()])));
        addFixedSize(views);
        addGap();
        iconButton(new JButton(), commands.picture);
        add(Box.createHorizontalGlue());
        for (Workspace arrangement : Workspace.values()) {
            JToggleButton door = new JToggleButton(arrangement.label());
            BreathDock.highlightWhenSelected(door);
            door.setName("toolbar." + arrangement.label());
            door.setToolTipText("Arrange the window for this: " + arrangement.label());
            door.getAccessibleContext().setAccessibleName("Arrange for: " + arrangement.label());
            door.addActionListener(e -> enter.accept(arrangement));
            workspaceButtons.put(arrangement, door);
            add(door);
        }
        addGroupSeparator();
        iconButton(new JButton(), commands.theme);
    }

    private <B extends AbstractButton> B iconButton(B button, MenuAction command) {
        button.setAction(command);
        button.setHideActionText(true);
        configure(button, command);
        return button;
    }

    private JToggleButton textButton(MenuAction command) {
        JToggleButton button = new JToggleButton(command);
        button.setIcon(null);
        configure(button, command);
        return button;
    }

    private void configure(AbstractButton button, MenuAction command) {
        String key = command.acceleratorText();
        button.setToolTipText(command.tip() + (key.isEmpty() ? "" : " (" + key + ")"));
        button.getAccessibleContext().setAccessibleName(command.name());
        button.setName("toolbar." + command.name());
        button.setFocusable(true);
        add(button);
    }

    private void addFixedSize(JComboBox<?> box) {
        box.setMaximumSize(box.getPreferredSize());
        add(box);
    }

    private void addGap() {
        add(Box.createRigidArea(new Dimension(8, 0)));
    }

    private void addGroupSeparator() {
        addSeparator(new Dimension(17, 22));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.borderColour()),
                BorderFactory.createEmptyBorder(3, 8, 3, 8)));
    }

    /** Shows for whom the window is arranged. */
    void showWorkspace(Workspace arrangement) {
        workspaceButtons.forEach((one, button) -> button.setSelected(one == arrangement));
    }

    /** Shows how things are, whoever changed them. */
    void refresh(Session session) {
        boolean playing = session.live().isPlaying();
        play.setIcon(playing ? Icons.PAUSE : Icons.PLAY);
        play.getAccessibleContext().setAccessibleName(playing ? "Pause" : "Play");
        boolean held = session.scenario().hold();
        boolean preset = session.scenario().trace().isEmpty();
        quiet.setSelected(preset && session.scenario().preset().equals("quiet"));
        deep.setSelected(preset && session.scenario().preset().equals("deep"));
        hold.setSelected(held);
    }
}
