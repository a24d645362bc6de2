package org.phrenic.scene;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * The virtual thorax for tests of drawing: its surfaces, a frame at rest and one in the middle of a breath, and a
 * context without a window.
 */
public final class SceneFixture implements AutoCloseable {
    /** Quiet inspiration is well on its way at this time of the first breath. */
    private static final double INSPIRED_S = 1.2;
    /** Early in the first inspiration. */
    private static final double BEGUN_S = 0.3;

    public final List<Surface> surfaces = Breath.ONCE.surfaces;
    public final List<Overlay> overlays;
    public final Frame rest = Breath.ONCE.rest.copy();
    public final Frame inspired = Breath.ONCE.inspired.copy();
    public final OffscreenContext offscreen;

    public SceneFixture() {
        offscreen = openOrSkip();
        overlays = someOverlays(rest.nodes().length / 3);
    }

    /** The breath, simulated once for all tests. */
    private static final class Breath {
        static final Breath ONCE = new Breath();

        final List<Surface> surfaces;
        final Frame rest;
        final Frame begun;
        final Frame inspired;

        Breath() {
            Scenario scenario = Scenario.defaults().with("resolution=low");
            try (Simulation simulation =
                    Simulation.of(scenario, VirtualThorax.ofPreset("adult-male", Resolution.LOW))) {
                SceneSurfaces scene = new SceneSurfaces(simulation);
                surfaces = scene.surfaces();
                rest = scene.newFrame();
                advance(simulation, BEGUN_S);
                begun = scene.newFrame();
                advance(simulation, INSPIRED_S);
                inspired = scene.newFrame();
            }
        }

        private static void advance(Simulation simulation, double untilS) {
            while (simulation.time() < untilS) {
                simulation.step();
            }
        }
    }

    /** The surfaces of the body, which take no context. */
    public static List<Surface> surfacesOfTheBody() {
        return Breath.ONCE.surfaces;
    }

    /** A frame early in the first inspiration, which takes no context. */
    public static Frame begunBreath() {
        return Breath.ONCE.begun.copy();
    }

    /** A context, or the test is skipped with the reason why there is none. */
    public static OffscreenContext openOrSkip() {
        try {
            return OffscreenContext.open();
        } catch (NoGraphicsException e) {
            return Assumptions.abort("no picture can be drawn here, so drawing is not tested: " + e.getMessage());
        }
    }

    /** One overlay of each kind: every node with its next, some points, and a line that stays. */
    private static List<Overlay> someOverlays(int nodes) {
        List<Overlay> overlays = new ArrayList<>();
        for (Overlay.Kind kind : Overlay.Kind.values()) {
            int[] pairs = new int[2 * nodes];
            for (int i = 0; i < nodes; i++) {
                pairs[2 * i] = i;
                pairs[2 * i + 1] = i % 3 == 0 ? i : (i + 1) % nodes;
            }
            overlays.add(new Overlay(kind, pairs, new float[] {0, 0, 0, 0, -300, 300}));
        }
        return overlays;
    }

    public SceneStyle style() {
        return SceneStyle.atlas(surfaces).withSamples(4);
    }

    public Camera camera(AnatomicalView view) {
        return Camera.of(view, bounds(surfaces), 4.0 / 3);
    }

    public String name(StructureKind kind) {
        return surfaces.stream()
                .filter(s -> s.kind() == kind)
                .findFirst()
                .orElseThrow()
                .name();
    }

    /** The style with all but some kinds hidden. */
    public SceneStyle only(SceneStyle style, StructureKind... kinds) {
        SceneStyle changed = style;
        for (Surface s : surfaces) {
            boolean shown = List.of(kinds).contains(s.kind());
            changed = changed.withAppearance(
                    s.name(), style.appearance(s.name()).orElseThrow().withVisible(shown));
        }
        return changed;
    }

    /** The box that holds all surfaces at rest. */
    public static double[] bounds(List<Surface> surfaces) {
        double[] box = surfaces.get(0).rest().bounds();
        for (Surface s : surfaces) {
            double[] other = s.rest().bounds();
            for (int i = 0; i < 3; i++) {
                box[i] = Math.min(box[i], other[i]);
                box[3 + i] = Math.max(box[3 + i], other[3 + i]);
            }
        }
        return box;
    }

    @Override
    public void close() {
        offscreen.close();
    }
}
