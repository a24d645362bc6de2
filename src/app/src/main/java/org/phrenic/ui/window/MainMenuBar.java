package org.phrenic.ui.window;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;

/** The menus, made from the commands. */
final class MainMenuBar extends JMenuBar {
    MainMenuBar(
            MenuActions commands,
            WindowPreferences preferences,
            Session session,
            Consumer<Path> open,
            Consumer<Workspace> arrange) {
        JMenu file = menu("File", 'F', List.of(commands.open));
        file.add(recentMenu(preferences, open));
        file.addSeparator();
        file.add(commands.save);
        file.add(commands.picture);
        file.add(commands.copy);
        file.addSeparator();
        file.add(commands.quit);
        JMenu edit = menu("Edit", 'E', List.of());
        JMenuItem undo = edit.add(commands.undo);
        JMenuItem redo = edit.add(commands.redo);
        session.edits().addListener(() -> {
            undo.setText(session.edits().undoPresentationName().orElse("Undo"));
            redo.setText(session.edits().redoPresentationName().orElse("Redo"));
            undo.setEnabled(session.edits().undoPresentationName().isPresent());
            redo.setEnabled(session.edits().redoPresentationName().isPresent());
        });
        menu(
                "Breath",
                'B',
                List.of(commands.play, commands.step, commands.reset, commands.quiet, commands.deep, commands.hold));
        menu("Needle", 'N', commands.needle);
        JMenu view = menu("View", 'V', commands.views);
        view.addSeparator();
        commands.docks.forEach(view::add);
        view.addSeparator();
        view.add(commands.theme);
        JMenu arrangement = new JMenu("Arrange for");
        for (Workspace a : Workspace.values()) {
            JMenuItem item = new JMenuItem(a.label());
            item.addActionListener(e -> arrange.accept(a));
            arrangement.add(item);
        }
        view.add(arrangement);
        menu("Help", 'H', commands.help);
    }

    private JMenu menu(String name, char mnemonic, List<MenuAction> commands) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        for (MenuAction command : commands) {
            JMenuItem item = menu.add(command);
            item.setIcon(null);
        }
        add(menu);
        return menu;
    }

    private static JMenu recentMenu(WindowPreferences preferences, Consumer<Path> open) {
        JMenu recent = new JMenu("Open recent");
        recent.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent e) {
                recent.removeAll();
                for (Path path : preferences.recent()) {
                    JMenuItem item = new JMenuItem(path.toString());
                    item.addActionListener(chosen -> open.accept(path));
                    recent.add(item);
                }
                if (recent.getItemCount() == 0) {
                    JMenuItem none = new JMenuItem("Nothing opened yet");
                    none.setEnabled(false);
                    recent.add(none);
                }
            }

            @Override
            public void menuDeselected(MenuEvent e) {
                // Filled again when it is next opened.
            }

            @Override
            public void menuCanceled(MenuEvent e) {
                // As above.
            }
        });
        return recent;
    }
}
