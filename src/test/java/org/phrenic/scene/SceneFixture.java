package org.phrenic.scene;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.Bodies;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.Surface;

/** The virtual thorax for tests of drawing: its surfaces, a frame at rest and one in the middle of a breath, and a context without a window. */
final class SceneFixture implements AutoCloseable {
    /** Quiet inspiration is well on its way at this time of the first breath. */
    private static final double INSPIRED_S = 1.2;

    final List<Surface> surfaces = Breath.ONCE.surfaces;
    final List<Overlay> overlays;
    final Frame rest = Breath.ONCE.rest.copy();
    final Frame inspired = Breath.ONCE.inspired.copy();
    final OffscreenGl offscreen;

    SceneFixture() {
        offscreen = openOrSkip();
        overlays = someOverlays(rest.nodes().length / 3);
    }

    /** The breath, simulated once for all tests. */
    private static final class Breath {
        static final Breath ONCE = new Breath();

        final List<Surface> surfaces;
        final Frame rest;
        final Frame inspired;

        Breath() {
            Scenario scenario = Scenario.defaults().with("resolution=low");
            try (Simulation simulation = Simulation.of(scenario, Bodies.grow("adult-male", Resolution.LOW))) {
                SceneSurfaces scene = new SceneSurfaces(simulation);
                surfaces = scene.surfaces();
                rest = scene.newFrame();
                while (simulation.time() < INSPIRED_S) {
                    simulation.step();
                }
                inspired = scene.newFrame();
            }
        }
    }

    /** A context, or the test is skipped with the reason why there is none. */
    static OffscreenGl openOrSkip() {
        try {
            return OffscreenGl.open();
        } catch (NoGraphicsException e) {
            assumeTrue(false, "no picture can be drawn here, so drawing is not tested: " + e.getMessage());
            throw new IllegalStateException(e);
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

    SceneStyle style() {
        return SceneStyle.atlas(surfaces).withSamples(4);
    }

    Camera camera(View view) {
        return Camera.of(view, bounds(surfaces), 4.0 / 3);
    }

    String name(StructureKind kind) {
        return surfaces.stream()
                .filter(s -> s.kind() == kind)
                .findFirst()
                .orElseThrow()
                .name();
    }

    /** The style with all but some kinds hidden. */
    SceneStyle only(SceneStyle style, StructureKind... kinds) {
        SceneStyle changed = style;
        for (Surface s : surfaces) {
            boolean shown = List.of(kinds).contains(s.kind());
            changed = changed.withLook(
                    s.name(), style.look(s.name()).orElseThrow().withVisible(shown));
        }
        return changed;
    }

    /** The box that holds all surfaces at rest. */
    static double[] bounds(List<Surface> surfaces) {
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
