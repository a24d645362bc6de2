package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javax.swing.JFrame;
import org.phrenic.ui.session.WindowPreferences;

/** Where the window is and how large: as it was left, on any of the screens that are there now. */
final class WindowBounds {
    private static final int MAX_WIDTH = 1440;
    private static final int MAX_HEIGHT = 900;
    private static final int MIN_WIDTH = 790;
    private static final int MIN_HEIGHT = 520;
    private static final double SCREEN_SHARE = 0.94;
    /** Height of a title bar, pixels. */
    private static final int TITLE_HEIGHT = 30;
    /** Size of the smallest part of a title bar by which a window can be moved, pixels: larger than its buttons. */
    private static final int GRASPED_WIDTH = 200;

    private static final int GRASPED_HEIGHT = 15;

    private WindowBounds() {}

    static void restore(JFrame frame, WindowPreferences preferences) {
        List<Rectangle> screens = screens();
        Rectangle usual = usual(screens.get(0));
        Rectangle last = new Rectangle(
                preferences.number("x", usual.x),
                preferences.number("y", usual.y),
                preferences.number("width", usual.width),
                preferences.number("height", usual.height));
        Rectangle bounds = onScreen(last, screens);
        frame.setMinimumSize(new Dimension(
                Math.min(bounds.width, UIScale.scale(MIN_WIDTH)), Math.min(bounds.height, UIScale.scale(MIN_HEIGHT))));
        frame.setBounds(bounds);
        if (preferences.flag("maximised", false)) {
            frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
        }
    }

    static void save(JFrame frame, WindowPreferences preferences) {
        boolean maximised = (frame.getExtendedState() & JFrame.MAXIMIZED_BOTH) == JFrame.MAXIMIZED_BOTH;
        preferences.setFlag("maximised", maximised);
        // A maximised window too comes back on its screen.
        preferences.setNumber("x", frame.getX());
        preferences.setNumber("y", frame.getY());
        if (!maximised) {
            preferences.setNumber("width", frame.getWidth());
            preferences.setNumber("height", frame.getHeight());
        }
    }

    /** What can be used of each screen, the first screen first. */
    private static List<Rectangle> screens() {
        GraphicsEnvironment environment = GraphicsEnvironment.getLocalGraphicsEnvironment();
        List<Rectangle> screens = new ArrayList<>();
        screens.add(environment.getMaximumWindowBounds());
        for (GraphicsDevice device : environment.getScreenDevices()) {
            GraphicsConfiguration configuration = device.getDefaultConfiguration();
            Rectangle usable = configuration.getBounds();
            Insets taken = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
            usable.x += taken.left;
            usable.y += taken.top;
            usable.width -= taken.left + taken.right;
            usable.height -= taken.top + taken.bottom;
            screens.add(usable);
        }
        return screens;
    }

    private static Rectangle usual(Rectangle screen) {
        int w = Math.min(MAX_WIDTH, (int) (SCREEN_SHARE * screen.width));
        int h = Math.min(MAX_HEIGHT, (int) (SCREEN_SHARE * screen.height));
        return new Rectangle(screen.x + (screen.width - w) / 2, screen.y + (screen.height - h) / 2, w, h);
    }

    /**
     * Bounds on the screen that shows most of the window, which is made smaller, and moved, where it is larger than
     * that screen, and moved onto it where no screen shows enough of the title bar to grasp it; the usual bounds on the
     * first screen if none shows the window.
     *
     * @param screens the first screen first
     */
    static Rectangle onScreen(Rectangle wanted, List<Rectangle> screens) {
        Rectangle screen = screens.stream()
                .max(Comparator.comparingLong(s -> area(s, wanted)))
                .orElseThrow();
        if (area(screen, wanted) == 0) {
            return usual(screens.get(0));
        }
        Rectangle bounds = new Rectangle(wanted);
        if (bounds.width > screen.width) {
            bounds.x = screen.x;
            bounds.width = screen.width;
        }
        if (bounds.height > screen.height) {
            bounds.y = screen.y;
            bounds.height = screen.height;
        }
        if (screens.stream().noneMatch(s -> showsTitle(s, bounds))) {
            bounds.x = Math.max(screen.x, Math.min(bounds.x, screen.x + screen.width - bounds.width));
            bounds.y = Math.max(screen.y, Math.min(bounds.y, screen.y + screen.height - bounds.height));
        }
        return bounds;
    }

    /** Whether a screen shows as much of the title bar of a window as is needed to move the window by it. */
    private static boolean showsTitle(Rectangle screen, Rectangle window) {
        Rectangle shown = screen.intersection(new Rectangle(window.x, window.y, window.width, TITLE_HEIGHT));
        return shown.width >= Math.min(GRASPED_WIDTH, window.width) && shown.height >= GRASPED_HEIGHT;
    }

    private static long area(Rectangle a, Rectangle b) {
        Rectangle both = a.intersection(b);
        return both.isEmpty() ? 0 : (long) both.width * both.height;
    }
}
