package org.phrenic.simulation.observe;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.MassSpringBuilder;

/** Builds the {@link Overlay}s of a scene. Kinds without elements are omitted. */
public final class SceneOverlays {
    /** Minimum contractile share of an edge for it to be drawn as a fibre: 30 degrees between the two. */
    private static final double ALONG = 0.625;

    private static final double ABOVE_MM = 40;
    private static final double AXIS_MM = 35;

    private SceneOverlays() {}

    public static List<Overlay> of(Scene scene) {
        NodeLayout layout = scene.system().layout();
        List<Overlay> all = new ArrayList<>();
        int[] sheet = scene.sheetSprings().callerPairs(layout);
        int[] passive = scene.passiveSprings().map(s -> s.callerPairs(layout)).orElse(new int[0]);
        addPairs(all, Overlay.Kind.SPRINGS, MassSpringBuilder.concatenate(sheet, passive));
        addPairs(
                all,
                Overlay.Kind.RIGID_LINKS,
                scene.links().map(l -> l.callerPairs(layout)).orElse(new int[0]));
        addPairs(
                all,
                Overlay.Kind.ATTACHMENTS,
                Arrays.stream(scene.heldNodes())
                        .flatMap(n -> IntStream.of(n, n))
                        .toArray());
        double[] fibre = scene.diaphragm().fibreShares();
        addPairs(
                all,
                Overlay.Kind.FIBRES,
                IntStream.range(0, fibre.length)
                        .filter(e -> fibre[e] >= ALONG)
                        .flatMap(e -> IntStream.of(sheet[2 * e], sheet[2 * e + 1]))
                        .toArray());
        addSegments(all, Overlay.Kind.ACTION_LINES, actionLines(scene));
        addSegments(all, Overlay.Kind.HELICAL_AXES, axes(scene.pose().cage()));
        return List.copyOf(all);
    }

    private static void addPairs(List<Overlay> all, Overlay.Kind kind, int[] pairs) {
        if (pairs.length > 0) {
            all.add(new Overlay(kind, pairs, new float[0]));
        }
    }

    private static void addSegments(List<Overlay> all, Overlay.Kind kind, List<double[]> points) {
        float[] segments = new float[3 * points.size()];
        for (int i = 0; i < segments.length; i++) {
            segments[i] = (float) points.get(i / 3)[i % 3];
        }
        if (segments.length > 0) {
            all.add(new Overlay(kind, new int[0], segments));
        }
    }

    /** Both end points of each line in turn. */
    private static List<double[]> actionLines(Scene scene) {
        List<double[]> ends = new ArrayList<>();
        double[] box = scene.diaphragm().diaphragm.sheet().bounds();
        for (double[] place : scene.actionLines()) {
            ends.add(new double[] {place[0], place[1], box[2] - ABOVE_MM});
            ends.add(new double[] {place[0], place[1], box[5] + ABOVE_MM});
        }
        return ends;
    }

    /** A segment of each axis, centred at the head of its rib. */
    private static List<double[]> axes(RibCage cage) {
        List<double[]> ends = new ArrayList<>();
        for (RibCage.Body body : cage.bodies()) {
            if (body.axis().isEmpty() || body.ends().isEmpty()) {
                continue;
            }
            HelicalAxis axis = body.axis().get();
            double[] head = body.ends().get().head();
            double along = (head[0] - axis.pointX()) * axis.directionX()
                    + (head[1] - axis.pointY()) * axis.directionY()
                    + (head[2] - axis.pointZ()) * axis.directionZ();
            for (double end : new double[] {along - AXIS_MM, along + AXIS_MM}) {
                ends.add(new double[] {
                    axis.pointX() + end * axis.directionX(),
                    axis.pointY() + end * axis.directionY(),
                    axis.pointZ() + end * axis.directionZ()
                });
            }
        }
        return ends;
    }
}
