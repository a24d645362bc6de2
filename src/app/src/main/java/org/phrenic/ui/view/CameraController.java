package org.phrenic.ui.view;

import java.awt.Point;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

/**
 * The mouse in the view: left drag orbits, middle or shift drag pans, the wheel zooms towards the cursor, a click names
 * the structure, a double click makes it the centre of rotation. The Enter key is a click in the middle.
 */
final class CameraController extends MouseAdapter {
    private static final double DEGREES_PER_PIXEL = 0.4;
    private static final double ZOOM_PER_NOTCH = 1.15;

    private final SceneViewport view;
    private Point lastPoint = new Point();
    private boolean toolHolds;

    CameraController(SceneViewport view) {
        this.view = view;
        view.addMouseListener(this);
        view.addMouseMotionListener(this);
        view.addMouseWheelListener(this);
        view.registerKeyboardAction(
                e -> view.click(view.getWidth() / 2, view.getHeight() / 2, false),
                KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0),
                JComponent.WHEN_FOCUSED);
        // The cross in the middle comes and goes with the focus.
        view.addFocusListener(new FocusListener() {
            @Override
            public void focusGained(FocusEvent e) {
                view.repaint();
            }

            @Override
            public void focusLost(FocusEvent e) {
                view.repaint();
            }
        });
    }

    @Override
    public void mousePressed(MouseEvent e) {
        lastPoint = e.getPoint();
        view.requestFocusInWindow();
        toolHolds = view.tool().filter(tool -> tool.pressed(e)).isPresent();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (toolHolds) {
            view.tool().ifPresent(tool -> tool.dragged(e));
            return;
        }
        double dx = e.getX() - lastPoint.getX();
        double dy = e.getY() - lastPoint.getY();
        lastPoint = e.getPoint();
        if (SwingUtilities.isMiddleMouseButton(e) || e.isShiftDown()) {
            view.setCamera(view.camera().pan(dx, dy, view.getHeight()));
        } else if (SwingUtilities.isLeftMouseButton(e)) {
            view.setCamera(view.camera().orbit(-DEGREES_PER_PIXEL * dx, DEGREES_PER_PIXEL * dy));
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        if (view.tool().isPresent() && view.tool().get().wheelTurned(e)) {
            return;
        }
        double factor = Math.pow(ZOOM_PER_NOTCH, -e.getPreciseWheelRotation());
        view.setCamera(view.camera().zoom(factor, e.getX(), e.getY(), view.getWidth(), view.getHeight()));
    }

    @Override
    public void mouseClicked(MouseEvent e) {
        if (SwingUtilities.isLeftMouseButton(e) && !toolHolds) {
            view.click(e.getX(), e.getY(), e.getClickCount() == 2);
        }
    }
}
