package org.phrenic.ui.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;

/** Updates the components to a new look and feel, a few per event, so that input is handled in between. */
public final class ThemeUpdater {
    private static final long SLICE_NS = 15_000_000;

    private final Deque<Component> pending = new ArrayDeque<>();
    private boolean running;

    /**
     * Starts an update, and ends one that is not finished.
     *
     * @param elsewhere components that may be in no window
     */
    public void start(List<? extends Component> elsewhere) {
        pending.clear();
        pending.addAll(Arrays.asList(Window.getWindows()));
        elsewhere.stream()
                .filter(part -> SwingUtilities.getWindowAncestor(part) == null)
                .forEach(pending::add);
        if (!running) {
            running = true;
            continueUpdate();
        }
    }

    private void continueUpdate() {
        long end = System.nanoTime() + SLICE_NS;
        while (!pending.isEmpty() && System.nanoTime() < end) {
            updateComponent(pending.pop());
        }
        running = !pending.isEmpty();
        if (running) {
            SwingUtilities.invokeLater(this::continueUpdate);
        } else {
            for (Window window : Window.getWindows()) {
                window.revalidate();
                window.repaint();
            }
        }
    }

    private void updateComponent(Component one) {
        if (one instanceof JComponent part) {
            part.updateUI();
            if (part.getComponentPopupMenu() != null) {
                pending.push(part.getComponentPopupMenu());
            }
        }
        List<Component> parts = one instanceof JMenu menu
                ? Arrays.asList(menu.getMenuComponents())
                : one instanceof Container container ? Arrays.asList(container.getComponents()) : List.of();
        Collections.reverse(parts);
        parts.forEach(pending::push);
    }
}
