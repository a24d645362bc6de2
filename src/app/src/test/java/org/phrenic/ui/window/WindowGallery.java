package org.phrenic.ui.window;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.prefs.Preferences;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;

/**
 * Leaves pictures of the whole window, light and dark, for tuning, among them those of the documentation:
 * {@code window-light.png} and {@code window-dark.png}. Needs a display. Argument: folder.
 */
public final class WindowGallery {
    /** Full inspiration of the second breath, quiet. */
    private static final double QUIET_S = 5.4;

    /** Full inspiration, deep. */
    private static final double DEEP_S = 3.4;

    private final Path folder;

    private WindowGallery(Path folder) {
        this.folder = folder;
    }

    public static void main(String[] arguments) throws Exception {
        int code = 1;
        try {
            new WindowGallery(Files.createDirectories(Path.of(arguments[0]))).showAll();
            code = 0;
        } finally {
            System.exit(code);
        }
    }

    private void showAll() throws Exception {
        show("window-light", 1280, 800, false, Workspace.RESEARCHER, false, "preset=quiet");
        show("window-dark", 1280, 800, true, Workspace.RESEARCHER, true, "preset=deep");
        show("tune-dark-large", 1600, 1000, true, Workspace.RESEARCHER, true, "preset=deep");
    }

    private void show(
            String name, int width, int height, boolean dark, Workspace arrangement, boolean field, String setting)
            throws Exception {
        Preferences node = Preferences.userRoot().node("org/phrenic/gallery");
        node.clear();
        node.putInt("width", width);
        node.putInt("height", height);
        node.putInt("x", 0);
        node.putInt("y", 0);
        node.putBoolean("dark", dark);
        node.put("arrangement", arrangement.name());
        Session session = new Session(Scenario.defaults().with(setting));
        PhrenicWindow[] made = new PhrenicWindow[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = new PhrenicWindow(new WindowPreferences(node), session);
            made[0].show();
        });
        PhrenicWindow window = made[0];
        waitFor(window, 0.5);
        SwingUtilities.invokeAndWait(() -> {
            if (field) {
                control(window, JComboBox.class, "Colours show").setSelectedIndex(1);
                JTextField most = control(window, JTextField.class, "Greatest value of the colours");
                most.setText("60");
                most.postActionEvent();
                control(window, JCheckBox.class, "Shape at rest").doClick();
            }
        });
        waitFor(window, setting.endsWith("deep") ? DEEP_S : QUIET_S);
        WindowHarness.writeAtRest(window, folder.resolve(name + ".png"));
        SwingUtilities.invokeAndWait(window::close);
        node.removeNode();
    }

    private static <C extends Component> C control(PhrenicWindow window, Class<C> kind, String name) {
        return WindowHarness.find(window.frame().getRootPane(), kind, name).orElseThrow();
    }

    private static void waitFor(PhrenicWindow window, double timeS) throws InterruptedException {
        while (window.view().frameCount() == 0
                || window.session().live().status().timeS() < timeS) {
            Thread.sleep(50);
        }
    }
}
