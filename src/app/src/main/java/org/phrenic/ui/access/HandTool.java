package org.phrenic.ui.access;

import java.awt.Point;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.ProbeMarker;
import org.phrenic.scene.camera.Camera;
import org.phrenic.ui.view.SceneViewport;

/**
 * Takes hold of probe and needle in the view: the left button slides the probe over the skin, or turns the needle by
 * its hub; the right button tilts and rocks the probe. Used on the event dispatch thread.
 */
final class HandTool {
    private static final double REACH_PX = 14;
    private static final double DEG_PER_PX = 0.25;
    /** A needle nearly along the line of sight is not turned by its hub. */
    private static final double LEAST_DEPTH = 1e-3;

    private enum Held {
        NOTHING,
        PROBE,
        PROBE_ANGLES,
        NEEDLE
    }

    private final RehearsalController rehearsal;
    private final SceneViewport view;
    private Held held = Held.NOTHING;
    private int lastX;
    private int lastY;
    private boolean searching;
    /** Where the mouse has gone during a search; empty if it has stayed. */
    private Optional<Point> wanted = Optional.empty();

    HandTool(RehearsalController rehearsal, SceneViewport view) {
        this.rehearsal = rehearsal;
        this.view = view;
    }

    /** Takes hold of what is under the mouse; false if that is nothing of its own. */
    boolean pressed(MouseEvent e) {
        held = Held.NOTHING;
        lastX = e.getX();
        lastY = e.getY();
        Optional<NeedleState> state = rehearsal.state().filter(s -> rehearsal.stage() == RehearsalStage.READY);
        state.ifPresent(s -> held = under(s, e));
        return held != Held.NOTHING;
    }

    private Held under(NeedleState state, MouseEvent e) {
        boolean left = SwingUtilities.isLeftMouseButton(e);
        if (left && state.hasNeedle() && hubDistance(state, e) < REACH_PX) {
            return Held.NEEDLE;
        }
        boolean onProbe = state.probe()
                        .map(p -> ProbeMarker.distancePx(
                                p.pose(), view.camera(), view.getWidth(), view.getHeight(), e.getX(), e.getY()))
                        .orElse(Double.POSITIVE_INFINITY)
                < REACH_PX;
        if (!onProbe) {
            return Held.NOTHING;
        }
        return left && !e.isControlDown() ? Held.PROBE : Held.PROBE_ANGLES;
    }

    private double hubDistance(NeedleState state, MouseEvent e) {
        double[] hub = state.hub();
        double[] xy = new double[2];
        boolean seen = view.camera().project(hub[0], hub[1], hub[2], view.getWidth(), view.getHeight(), xy);
        return seen ? Math.hypot(xy[0] - e.getX(), xy[1] - e.getY()) : Double.POSITIVE_INFINITY;
    }

    void dragged(MouseEvent e) {
        int dx = e.getX() - lastX;
        int dy = e.getY() - lastY;
        lastX = e.getX();
        lastY = e.getY();
        switch (held) {
            case NEEDLE -> rehearsal.state().filter(NeedleState::hasNeedle).ifPresent(state -> turnNeedle(state, e));
            case PROBE -> slideProbe(e.getPoint());
            case PROBE_ANGLES -> rehearsal.probe().turn(0, DEG_PER_PX * dy, -DEG_PER_PX * dx);
            case NOTHING -> {}
        }
    }

    /** Slides the probe to the skin under the mouse; while a search is under way the last place counts. */
    private void slideProbe(Point to) {
        if (searching) {
            wanted = Optional.of(to);
            return;
        }
        searching = true;
        view.pick(to.x, to.y, rehearsal.skinOpacity(), found -> {
            searching = false;
            Optional<Point> next = wanted;
            wanted = Optional.empty();
            // A probe that was lifted meanwhile stays lifted.
            if (rehearsal.probe().hold().isPresent()) {
                found.ifPresent(place -> rehearsal.probe().put(place.restPosition()));
                next.ifPresent(this::slideProbe);
            }
        });
    }

    /** Turns the needle so that its hub is under the mouse, in the plane of the picture through the hub. */
    private void turnNeedle(NeedleState state, MouseEvent e) {
        double[] entry = state.entry().orElseThrow();
        Camera camera = view.camera();
        double[] ray = camera.ray(e.getX(), e.getY(), view.getWidth(), view.getHeight());
        double[] from = {ray[0], ray[1], ray[2]};
        double[] along = {ray[3], ray[4], ray[5]};
        double[] toViewer = {camera.towardsViewer().x, camera.towardsViewer().y, camera.towardsViewer().z};
        double slope = Vectors.dot(along, toViewer);
        double distance = Vectors.dot(Vectors.subtract(state.hub(), from), toViewer) / slope;
        double[] hub = Vectors.addScaled(from, along, distance);
        double[] direction = Vectors.subtract(entry, hub);
        if (Math.abs(slope) > LEAST_DEPTH && Vectors.length(direction) > 1) {
            rehearsal.needle().turnTo(NeedleAngles.of(direction));
        }
    }
}
