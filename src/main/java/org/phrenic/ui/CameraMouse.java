package org.phrenic.ui;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;

/** The mouse in the view: left drag turns, middle or shift drag moves, the wheel enlarges towards the cursor, a click names, a double click turns the view about that place. */
final class CameraMouse extends MouseAdapter {
    private static final double DEGREES_A_PIXEL = 0.4;
    private static final double ENLARGE_A_NOTCH = 1.15;

    private final SceneView view;
    private Point last = new Point();

    CameraMouse(SceneView view) {
        this.view = view;
        view.addMouseListener(this);
        view.addMouseMotionListener(this);
        view.addMouseWheelListener(this);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        last = e.getPoint();
        view.requestFocusInWindow();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        double dx = e.getX() - last.getX();
        double dy = e.getY() - last.getY();
        last = e.getPoint();
        if (SwingUtilities.isMiddleMouseButton(e) || e.isShiftDown()) {
            view.setCamera(view.camera().pan(dx, dy, view.getHeight()));
        } else if (SwingUtilities.isLeftMouseButton(e)) {
            view.setCamera(view.camera().orbit(-DEGREES_A_PIXEL * dx, DEGREES_A_PIXEL * dy));
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        if (view.tool().isPresent() && view.tool().get().turned(e)) {
            return;
        }
        double factor = Math.pow(ENLARGE_A_NOTCH, -e.getPreciseWheelRotation());
        view.setCamera(view.camera().zoom(factor, e.getX(), e.getY(), view.getWidth(), view.getHeight()));
    }

    @Override
    public void mouseClicked(MouseEvent e) {
        if (SwingUtilities.isLeftMouseButton(e)) {
            view.click(e.getX(), e.getY(), e.getClickCount() == 2);
        }
    }
}
