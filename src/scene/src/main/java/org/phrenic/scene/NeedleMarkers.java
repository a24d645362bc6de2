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
import java.util.Set;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Surface;

/**
 * Markers of a rehearsal in the scene: target, needle, and the planned path in the colour of its advice level. Needle
 * and path are drawn thicker than they are, for visibility.
 *
 * @param level advice level of the planned path
 * @param seeThrough whether what lies in the body is shown
 */
public record NeedleMarkers(NeedleState state, PathAdvice.Level level, boolean seeThrough) {
    private static final String NEEDLE = Markers.PREFIX + "needle";
    private static final String HUB = Markers.PREFIX + "hub";
    private static final String TARGET = Markers.PREFIX + "target";
    private static final String PATH = Markers.PREFIX + "way_";
    private static final String ENTRY = Markers.PREFIX + "entry_";
    private static final Color TARGET_LINE = new Color(0xb38f00);
    private static final Color TARGET_RIM = new Color(0x2b, 0x22, 0, 200);
    private static final float TARGET_RIM_WIDTH = 4;
    private static final Color NEEDLE_LINE = new Color(0x1f4e79);
    private static final Color PLANE_LINE = new Color(0x2f86d6);
    private static final Color PLANE_FILL = new Color(0x2f, 0x86, 0xd6, 34);
    private static final double NEEDLE_MM = 1.2;
    private static final double HUB_MM = 2.6;
    private static final double HUB_LENGTH_MM = 18;
    private static final double PATH_MM = 0.9;
    private static final double ENTRY_MM = 3;

    /** Marker surfaces, to be added to the surfaces of a body. */
    public static List<Surface> surfaces() {
        List<Surface> all = new ArrayList<>();
        all.add(Markers.movingRod(NEEDLE));
        all.add(Markers.movingRod(HUB));
        all.add(Markers.movingBall(TARGET));
        all.add(ProbeMarker.housing());
        all.add(ProbeMarker.mark());
        for (PathAdvice.Level level : PathAdvice.Level.values()) {
            all.add(Markers.movingRod(PATH + level));
            all.add(Markers.movingBall(ENTRY + level));
        }
        return all;
    }

    /** A style that shows the body from outside: its skin hides what is within. */
    public static SceneStyle fromOutside(SceneStyle style, List<Surface> surfaces) {
        return style.withOverlays(Set.of())
                .withRestWireframe(false)
                .withClip(Optional.empty())
                .withField(ColourField.NONE, "", style.scale())
                .withAppearances(
                        surfaces,
                        (s, usual) ->
                                s.kind() == StructureKind.SKIN ? new Appearance(true, usual.rgb(), 1, false) : usual);
    }

    /** Sets the marker poses in a renderer and returns the style that shows the markers. */
    public static SceneStyle apply(Optional<NeedleMarkers> marks, Renderer renderer, SceneStyle style) {
        if (marks.isEmpty()) {
            return style;
        }
        NeedleState state = marks.get().state();
        Map<String, Appearance> looks = new LinkedHashMap<>(style.appearances());
        if (marks.get().seeThrough()) {
            renderer.setPose(TARGET, Markers.ballPose(state.target(), state.targetRadiusMm()));
            looks.put(TARGET, NeedlePictures.TARGET_APPEARANCE);
        }
        state.probe().ifPresent(probe -> {
            renderer.setPose(ProbeMarker.HOUSING, ProbeMarker.housingPose(probe.pose()));
            renderer.setPose(ProbeMarker.MARK, ProbeMarker.markPose(probe.pose()));
            looks.put(ProbeMarker.HOUSING, Appearance.of(ProbeMarker.HOUSING_RGB, 1));
            looks.put(ProbeMarker.MARK, Appearance.of(ProbeMarker.MARK_RGB, 1));
        });
        if (state.entry().isPresent()) {
            double[] entry = state.entry().get();
            PathAdvice.Level level = marks.get().level();
            double[] end = pointAlong(entry, state.tip(), state.hub(), state.aimedDepthMm());
            if (marks.get().seeThrough()) {
                renderer.setPose(PATH + level, Markers.rodPose(entry, end, PATH_MM));
                renderer.setPose(ENTRY + level, Markers.ballPose(entry, ENTRY_MM));
                looks.put(PATH + level, Appearance.of(rgb(level), 1));
                looks.put(ENTRY + level, Appearance.of(rgb(level), 1));
            }
            double[] hub = state.hub();
            renderer.setPose(NEEDLE, Markers.rodPose(hub, state.tip(), NEEDLE_MM));
            renderer.setPose(HUB, Markers.rodPose(hub, pointAlong(hub, state.tip(), hub, -HUB_LENGTH_MM), HUB_MM));
            looks.put(NEEDLE, NeedlePictures.NEEDLE_APPEARANCE);
            looks.put(HUB, NeedlePictures.NEEDLE_APPEARANCE);
        }
        return style.withAppearances(looks);
    }

    /**
     * Draws outlines of target, path and needle over a picture, so that they show through structures in front of them.
     *
     * @param width width of the picture, in pixels of {@code graphics}
     * @param height height of the picture, in pixels of {@code graphics}
     */
    public void drawOutlines(Graphics2D graphics, Camera camera, int width, int height) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        if (!seeThrough) {
            g.dispose();
            return;
        }
        state.probe()
                .flatMap(probe -> ProbeMarker.outline(probe, camera, width, height))
                .ifPresent(plane -> {
                    g.setColor(PLANE_FILL);
                    g.fill(plane);
                    line(g, plane, PLANE_LINE, 1.5f, false);
                });
        double[] at = new double[2];
        double[] target = state.target();
        if (camera.project(target[0], target[1], target[2], width, height, at)) {
            double r = state.targetRadiusMm() / camera.mmPerPixelAt(target[0], target[1], target[2], height);
            Shape ring = new Ellipse2D.Double(at[0] - r, at[1] - r, 2 * r, 2 * r);
            // A light rim would not set it off the bright colours of the access map.
            stroke(g, ring, TARGET_RIM, TARGET_RIM_WIDTH, false);
            stroke(g, ring, TARGET_LINE, 2, false);
        }
        if (state.entry().isPresent()) {
            double[] entry = state.entry().get();
            double[] end = pointAlong(entry, state.tip(), state.hub(), state.aimedDepthMm());
            segment(camera, entry, end, width, height).ifPresent(s -> line(g, s, new Color(rgb(level)), 2, true));
            segment(camera, state.hub(), state.tip(), width, height)
                    .ifPresent(s -> line(g, s, NEEDLE_LINE, 2.5f, false));
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
        stroke(g, shape, new Color(255, 255, 255, 150), width + 2, dashed);
        stroke(g, shape, colour, width, dashed);
    }

    private static void stroke(Graphics2D g, Shape shape, Color colour, float width, boolean dashed) {
        float[] dashes = dashed ? new float[] {7, 5} : null;
        g.setColor(colour);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0));
        g.draw(shape);
    }

    private static double[] pointAlong(double[] from, double[] tip, double[] hub, double mm) {
        double[] along = Vectors.normalize(Vectors.subtract(tip, hub));
        return Vectors.addScaled(from, along, mm);
    }

    /** Colour of an advice level as {@code 0xRRGGBB}. */
    public static int rgb(PathAdvice.Level level) {
        return switch (level) {
            case FREE -> 0x0f8a7c;
            case CAREFUL -> 0xe08a12;
            case BARRED -> 0xc8321f;
        };
    }
}
