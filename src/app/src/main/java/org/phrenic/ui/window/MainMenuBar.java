package org.phrenic.ui.window;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.phrenic.ui.session.EditHistory;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;

/** The menu bar, made from the actions. */
final class MainMenuBar extends JMenuBar {
    MainMenuBar(
            MenuActions actions,
            WindowPreferences preferences,
            EditHistory edits,
            Consumer<Path> open,
            Consumer<Workspace> showWorkspace) {
        JMenu file = addMenu("File", 'F', List.of(actions.open));
        file.add(new RecentMenu(preferences, open));
        file.add(actions.importScan).setIcon(null);
        file.addSeparator();
        List.of(actions.save, actions.picture, actions.copy).forEach(file::add);
        file.addSeparator();
        file.add(actions.quit);
        JMenu edit = addMenu("Edit", 'E', List.of());
        JMenuItem undo = edit.add(actions.undo);
        JMenuItem redo = edit.add(actions.redo);
        Runnable showEdits = () -> {
            undo.setText(edits.undoPresentationName().orElse("Undo"));
            redo.setText(edits.redoPresentationName().orElse("Redo"));
            actions.undo.setEnabled(edits.undoPresentationName().isPresent());
            actions.redo.setEnabled(edits.redoPresentationName().isPresent());
        };
        showEdits.run();
        edits.addListener(showEdits);
        addMenu(
                "Breath",
                'B',
                List.of(actions.play, actions.step, actions.reset, actions.quiet, actions.deep, actions.hold));
        addMenu("Needle", 'N', actions.needle);
        addMenu("Probe", 'P', actions.probe);
        JMenu view = addMenu("View", 'V', actions.views);
        JMenu camera = new JMenu("Move the camera");
        actions.camera.forEach(camera::add);
        view.add(camera);
        view.addSeparator();
        actions.docks.forEach(dock -> view.add(new JCheckBoxMenuItem(dock)));
        view.addChangeListener(e -> actions.docks.forEach(MenuAction::showState));
        view.addSeparator();
        view.add(actions.theme);
        JMenu workspaces = new JMenu("Arrange for");
        for (Workspace workspace : Workspace.values()) {
            workspaces.add(workspace.label()).addActionListener(e -> showWorkspace.accept(workspace));
        }
        view.add(workspaces);
        addMenu("Help", 'H', actions.help);
    }

    private JMenu addMenu(String name, char mnemonic, List<MenuAction> actions) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        actions.forEach(action -> menu.add(action).setIcon(null));
        add(menu);
        return menu;
    }

    /** Files opened lately, listed when the menu opens. */
    private static final class RecentMenu extends JMenu implements MenuListener {
        private final transient WindowPreferences preferences;
        private final transient Consumer<Path> open;

        RecentMenu(WindowPreferences preferences, Consumer<Path> open) {
            super("Open recent");
            this.preferences = preferences;
            this.open = open;
            addMenuListener(this);
        }

        @Override
        public void menuSelected(MenuEvent e) {
            removeAll();
            preferences.recent().forEach(path -> add(path.toString()).addActionListener(a -> open.accept(path)));
            if (getItemCount() == 0) {
                add("Nothing opened yet").setEnabled(false);
            }
        }

        @Override
        public void menuDeselected(MenuEvent e) {}

        @Override
        public void menuCanceled(MenuEvent e) {}
    }
}
