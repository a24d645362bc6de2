package org.phrenic.ui.dock;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.chart.PlotDock;
import org.phrenic.ui.chart.TimelineDock;
import org.phrenic.ui.session.ScenarioStore;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Theme;

/**
 * Shows every dock with a breathing scene, light and dark, and leaves pictures of them: what changes in a dock is
 * looked at here. Needs a display.
 */
final class DockGallery {
    private static final double BREATHE_S = 9;

    private DockGallery() {}

    /** @param arguments folder for the pictures, then settings as key=value */
    public static void main(String[] arguments) throws Exception {
        int code = 1;
        try {
            showAll(arguments);
            code = 0;
        } catch (Exception e) {
            e.printStackTrace();
        } finally {
            System.exit(code);
        }
    }

    private static void showAll(String[] arguments) throws Exception {
        Path folder = Files.createDirectories(Path.of(arguments[0]));
        for (boolean dark : new boolean[] {false, true}) {
            SwingUtilities.invokeAndWait(() -> Theme.install(dark));
            Scenario scenario = Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic");
            for (int i = 1; i < arguments.length; i++) {
                scenario = scenario.with(arguments[i]);
            }
            show(scenario, folder, dark ? "dark" : "light");
        }
    }

    private static void show(Scenario scenario, Path folder, String theme) throws Exception {
        Map<String, JFrame> frames = new LinkedHashMap<>();
        Session[] session = new Session[1];
        PlotDock[] plot = new PlotDock[1];
        SettingsDock[] settings = new SettingsDock[1];
        SwingUtilities.invokeAndWait(() -> {
            session[0] = new Session(scenario);
            plot[0] = new PlotDock(session[0]);
            ScenarioStore store = new ScenarioStore(folder.resolve("settings"));
            store.save("Quiet, stiff tendon", scenario);
            store.save("Deep", scenario.with("preset=deep"));
            frames.put("parameters", frame(new ParameterDock(session[0]), 360, 900));
            frames.put("parameters-narrow", frame(new ParameterDock(session[0]), 300, 500));
            frames.put("breath", frame(new BreathDock(session[0]), 360, 470));
            frames.put("forces", frame(new ForcesDock(session[0]), 360, 330));
            settings[0] = new SettingsDock(session[0], store, null, null, plot[0]);
            frames.put("settings", frame(settings[0], 360, 460));
            frames.put("timeline", frame(new TimelineDock(session[0]), 1100, 70));
            frames.put("plot", frame(plot[0], 1100, 330));
        });
        breathe(session[0], BREATHE_S);
        SwingUtilities.invokeAndWait(settings[0]::swap);
        breathe(session[0], 2 * BREATHE_S + 3);
        SwingUtilities.invokeAndWait(() -> {
            session[0].change(
                    "Muscle stiffness 300 -> 420 N/m", Assignment.read("gallery", "muscle_stiffness_n_per_m", "420"));
            session[0].change("Hold of the breath", Assignment.read("gallery", "hold", "true"));
        });
        Thread.sleep(600);
        SwingUtilities.invokeAndWait(() -> {
            session[0].live().pause();
            session[0].showHistoryFrame(60);
        });
        Thread.sleep(400);
        for (Map.Entry<String, JFrame> entry : frames.entrySet()) {
            SwingUtilities.invokeAndWait(() ->
                    picture(entry.getValue().getContentPane(), folder.resolve(entry.getKey() + "-" + theme + ".png")));
        }
        SwingUtilities.invokeAndWait(() -> {
            session[0].close();
            frames.values().forEach(JFrame::dispose);
        });
    }

    private static void breathe(Session session, double untilS) throws InterruptedException {
        while (session.scene().isEmpty() || session.live().status().timeS() < untilS) {
            Thread.sleep(100);
        }
    }

    private static JFrame frame(JComponent dock, int width, int height) {
        JFrame frame = new JFrame();
        frame.add(dock);
        frame.getContentPane().setPreferredSize(new java.awt.Dimension(width, height));
        frame.pack();
        frame.setVisible(true);
        return frame;
    }

    private static void picture(Component content, Path file) {
        BufferedImage image = new BufferedImage(content.getWidth(), content.getHeight(), BufferedImage.TYPE_INT_RGB);
        content.paint(image.getGraphics());
        try {
            ImageIO.write(image, "png", file.toFile());
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }
}
