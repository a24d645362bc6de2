package org.phrenic.ui;

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
import org.phrenic.scene.View;

/** The buttons at the top: run, breathe, look. */
final class ToolBar extends JToolBar {
    private static final View[] VIEWS = {
        View.ANTERIOR, View.POSTERIOR, View.LEFT, View.RIGHT, View.SUPERIOR, View.INFERIOR
    };
    private static final String[] VIEW_NAMES = {
        "From the front", "From behind", "From the left", "From the right", "From above", "From below"
    };

    private final JButton play;
    private final JToggleButton hold;
    private final JToggleButton quiet;
    private final JToggleButton deep;
    private final JComboBox<Speed> speed = new JComboBox<>(Speed.values());

    private final Map<Arrangement, JToggleButton> doors = new EnumMap<>(Arrangement.class);

    /** @param enter told for whom the window is to be arranged */
    ToolBar(Commands commands, Session session, SceneView view, Consumer<Arrangement> enter) {
        setFloatable(false);
        setName("toolbar");
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.line()),
                BorderFactory.createEmptyBorder(3, 8, 3, 8)));
        play = button(new JButton(), commands.play);
        button(new JButton(), commands.step);
        button(new JButton(), commands.reset);
        gap();
        speed.setSelectedItem(Speed.REAL);
        speed.setToolTipText("How fast simulated time may go against real time");
        speed.getAccessibleContext().setAccessibleName("Speed");
        speed.addActionListener(e -> session.setSpeed(((Speed) speed.getSelectedItem()).factor()));
        fixed(speed);
        separator();
        quiet = text(commands.quiet);
        deep = text(commands.deep);
        hold = text(commands.hold);
        separator();
        JComboBox<String> views = new JComboBox<>(VIEW_NAMES);
        views.setToolTipText("From where to look");
        views.getAccessibleContext().setAccessibleName("View");
        views.addActionListener(e -> view.setCamera(view.camera().seen(VIEWS[views.getSelectedIndex()])));
        fixed(views);
        gap();
        button(new JButton(), commands.picture);
        add(Box.createHorizontalGlue());
        for (Arrangement arrangement : Arrangement.values()) {
            JToggleButton door = new JToggleButton(arrangement.label());
            BreathDock.marked(door);
            door.setName("toolbar." + arrangement.label());
            door.setToolTipText("Arrange the window for this: " + arrangement.label());
            door.getAccessibleContext().setAccessibleName("Arrange for: " + arrangement.label());
            door.addActionListener(e -> enter.accept(arrangement));
            doors.put(arrangement, door);
            add(door);
        }
        separator();
        button(new JButton(), commands.theme);
    }

    private <B extends AbstractButton> B button(B button, Command command) {
        button.setAction(command);
        button.setHideActionText(true);
        dress(button, command);
        return button;
    }

    private JToggleButton text(Command command) {
        JToggleButton button = new JToggleButton(command);
        button.setIcon(null);
        dress(button, command);
        return button;
    }

    private void dress(AbstractButton button, Command command) {
        String key = command.keyText();
        button.setToolTipText(command.tip() + (key.isEmpty() ? "" : " (" + key + ")"));
        button.getAccessibleContext().setAccessibleName(command.name());
        button.setName("toolbar." + command.name());
        button.setFocusable(true);
        add(button);
    }

    private void fixed(JComboBox<?> box) {
        box.setMaximumSize(box.getPreferredSize());
        add(box);
    }

    private void gap() {
        add(Box.createRigidArea(new Dimension(8, 0)));
    }

    private void separator() {
        addSeparator(new Dimension(17, 22));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.line()),
                BorderFactory.createEmptyBorder(3, 8, 3, 8)));
    }

    /** Shows for whom the window is arranged. */
    void show(Arrangement arrangement) {
        doors.forEach((one, button) -> button.setSelected(one == arrangement));
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
