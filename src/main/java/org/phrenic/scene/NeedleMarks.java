package org.phrenic.scene;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.geometry.Vectors;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.simulation.Surface;

/**
 * What a rehearsal adds to a scene: target, needle, and the way that it is to go, coloured as it may be gone. Drawn thicker than they are, so that they are seen.
 *
 * @param state how the rehearsal stands
 * @param level how the way is marked
 */
public record NeedleMarks(NeedleState state, PathAdvice.Level level) {
    private static final String NEEDLE = Markers.MOVING + "needle";
    private static final String HUB = Markers.MOVING + "hub";
    private static final String TARGET = Markers.MOVING + "target";
    private static final String WAY = Markers.MOVING + "way_";
    private static final String ENTRY = Markers.MOVING + "entry_";
    private static final Color TARGET_LINE = new Color(0xb38f00);
    private static final Color NEEDLE_LINE = new Color(0x1f4e79);
    private static final double NEEDLE_MM = 1.2;
    private static final double HUB_MM = 2.6;
    private static final double HUB_LENGTH_MM = 18;
    private static final double WAY_MM = 0.9;
    private static final double ENTRY_MM = 3;

    /** Surfaces to be added to those of a body. */
    public static List<Surface> surfaces() {
        List<Surface> all = new ArrayList<>();
        all.add(Markers.movingRod(NEEDLE));
        all.add(Markers.movingRod(HUB));
        all.add(Markers.movingBall(TARGET));
        for (PathAdvice.Level level : PathAdvice.Level.values()) {
            all.add(Markers.movingRod(WAY + level));
            all.add(Markers.movingBall(ENTRY + level));
        }
        return all;
    }

    /** Puts the marks where they are, and gives the style in which they are seen. */
    public static SceneStyle place(Optional<NeedleMarks> marks, Renderer renderer, SceneStyle style) {
        if (marks.isEmpty()) {
            return style;
        }
        NeedleState state = marks.get().state();
        Map<String, Look> looks = new LinkedHashMap<>(style.looks());
        renderer.place(TARGET, Markers.ballAt(state.target(), state.targetRadiusMm()));
        looks.put(TARGET, NeedlePictures.TARGET_LOOK);
        if (state.entry().isPresent()) {
            double[] entry = state.entry().get();
            PathAdvice.Level level = marks.get().level();
            double[] end = ahead(entry, state.tip(), state.hub(), state.aimedMm());
            renderer.place(WAY + level, Markers.rodAt(entry, end, WAY_MM));
            renderer.place(ENTRY + level, Markers.ballAt(entry, ENTRY_MM));
            looks.put(WAY + level, look(level));
            looks.put(ENTRY + level, look(level));
            if (state.placed()) {
                double[] hub = state.hub();
                renderer.place(NEEDLE, Markers.rodAt(hub, state.tip(), NEEDLE_MM));
                renderer.place(HUB, Markers.rodAt(hub, ahead(hub, state.tip(), hub, -HUB_LENGTH_MM), HUB_MM));
                looks.put(NEEDLE, NeedlePictures.NEEDLE_LOOK);
                looks.put(HUB, NeedlePictures.NEEDLE_LOOK);
            }
        }
        return style.withLooks(looks);
    }

    /**
     * Draws outlines of target, way and needle over a picture, so that they are seen through whatever lies before them.
     *
     * @param width of the picture, in pixels of {@code graphics}
     * @param height as above
     */
    public void outline(Graphics2D graphics, Camera camera, int width, int height) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        double[] at = new double[2];
        double[] target = state.target();
        if (camera.project(target[0], target[1], target[2], width, height, at)) {
            double r = state.targetRadiusMm() / camera.mmPerPixel(height);
            line(g, new Ellipse2D.Double(at[0] - r, at[1] - r, 2 * r, 2 * r), TARGET_LINE, 2, false);
        }
        if (state.entry().isPresent()) {
            double[] entry = state.entry().get();
            double[] end = ahead(entry, state.tip(), state.hub(), state.aimedMm());
            segment(camera, entry, end, width, height)
                    .ifPresent(s -> line(g, s, new Color(rgb(level)), 2, true));
            if (state.placed()) {
                segment(camera, state.hub(), state.tip(), width, height)
                        .ifPresent(s -> line(g, s, NEEDLE_LINE, 2.5f, false));
            }
        }
        g.dispose();
    }

    private static Optional<Line2D> segment(Camera camera, double[] a, double[] b, int width, int height) {
        double[] from = new double[2];
        double[] to = new double[2];
        boolean seen = camera.project(a[0], a[1], a[2], width, height, from)
                && camera.project(b[0], b[1], b[2], width, height, to);
        return seen ? Optional.of(new Line2D.Double(from[0], from[1], to[0], to[1])) : Optional.empty();
    }

    private static void line(Graphics2D g, Shape shape, Color colour, float width, boolean dashed) {
        float[] dashes = dashed ? new float[] {7, 5} : null;
        g.setColor(new Color(255, 255, 255, 150));
        g.setStroke(new BasicStroke(width + 2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0));
        g.draw(shape);
        g.setColor(colour);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0));
        g.draw(shape);
    }

    private static double[] ahead(double[] from, double[] tip, double[] hub, double mm) {
        double[] along = Vectors.unit(Vectors.minus(tip, hub));
        return Vectors.add(from, along, mm);
    }

    private static Look look(PathAdvice.Level level) {
        return Look.of(
                switch (level) {
                    case FREE -> 0x0f8a7c;
                    case CAREFUL -> 0xe08a12;
                    case BARRED -> 0xc8321f;
                },
                1);
    }

    /** Colour of a mark as {@code 0xRRGGBB}. */
    public static int rgb(PathAdvice.Level level) {
        float[] c = look(level).rgb();
        return Math.round(255 * c[0]) << 16 | Math.round(255 * c[1]) << 8 | Math.round(255 * c[2]);
    }
}
