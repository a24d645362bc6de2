package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;

/** What is drawn of a scene, in a deep breath of the coarse virtual adult male. */
class SceneSurfacesTest {
    /** Of 20 deep breaths a minute, each 3 s long and in after 1.35 s. */
    private static final int END_INSPIRATION = 1200;
    /** Bone may come so much farther out of the skin in a deep breath than it does at rest. */
    private static final double THROUGH_MM = 1;
    /** Rise of a line away from the axis of the trunk, so that it runs along no edges of the mesh. */
    private static final double RISE_MM = 7;

    /**
     * Distance from the skin of a vertex outside of it. A line away from the axis of the trunk passes the skin an odd
     * number of times from within; only where it does not, in a fold or outside, is the winding number needed, which
     * takes a pass over all triangles.
     */
    private static double outside(TriangleTree skin, TriangleMesh bone, int vertex) {
        double x = bone.x(vertex);
        double y = bone.y(vertex);
        double z = bone.z(vertex);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        if (skin.countAlongRay(x, y, z, x, y, RISE_MM, hit) % 2 == 1 || skin.isInside(x, y, z)) {
            return 0;
        }
        skin.closest(x, y, z, hit);
        return Math.sqrt(hit.distanceSquared);
    }

    private static boolean isBone(Surface surface) {
        return surface.kind() == StructureKind.RIB || surface.kind() == StructureKind.STERNUM;
    }

    @Test
    void inADeepBreathNoBoneComesThroughTheSkinTheBellyComesForwardAndTheBackStays() {
        try (Simulation simulation =
                Runs.simulation(Runs.scenario(Runs.sheetAlone("preset=deep", "rate_per_min=20")))) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            int skin = surfaces.surfaces().stream().map(Surface::kind).toList().indexOf(StructureKind.SKIN);
            List<TriangleMesh> rest = surfaces.meshes();
            for (int i = 0; i < END_INSPIRATION; i++) {
                simulation.step();
            }
            List<TriangleMesh> now = surfaces.meshes();
            TriangleTree skinAtRest = new TriangleTree(rest.get(skin));
            TriangleTree skinNow = new TriangleTree(now.get(skin));
            for (int s = 0; s < rest.size(); s++) {
                if (isBone(surfaces.surfaces().get(s))) {
                    for (int v = 0; v < rest.get(s).vertexCount(); v++) {
                        double out = outside(skinNow, now.get(s), v);
                        // Where it stood at rest costs as much to know, and counts only for what is out now.
                        if (out >= THROUGH_MM) {
                            assertThat(out)
                                    .as(surfaces.surfaces().get(s).name())
                                    .isLessThan(outside(skinAtRest, rest.get(s), v) + THROUGH_MM);
                        }
                    }
                }
            }
            double belly = 0;
            double farthest = 0;
            double back = 0;
            TriangleMesh before = rest.get(skin);
            TriangleMesh after = now.get(skin);
            double behind = before.bounds()[4] - 30;
            for (int v = 0; v < before.vertexCount(); v++) {
                double y = after.y(v) - before.y(v);
                double moved = Math.hypot(Math.hypot(after.x(v) - before.x(v), y), after.z(v) - before.z(v));
                belly = Math.max(belly, before.z(v) < -40 ? -y : 0);
                farthest = Math.max(farthest, moved);
                back = Math.max(back, before.y(v) > behind && before.z(v) < -40 ? moved : 0);
            }
            // Some 1.4 l over a wall of some 30 by 30 cm.
            assertThat(belly).isBetween(10.0, 50.0);
            assertThat(farthest).isLessThan(60);
            assertThat(back).isLessThan(10);
        }
    }

    @Test
    void captureAllocatesNextToNothingAndAStepNothingAlsoWhileAChangeRampsIn() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (Simulation simulation = Runs.simulation(Runs.scenario("threads=1"))) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            Frame frame = surfaces.newFrame();
            for (int i = 0; i < 30; i++) {
                surfaces.capture(frame);
                simulation.step();
            }
            simulation.change(Assignment.parse("muscle_stiffness_n_per_m=330"));
            simulation.step();
            long thread = Thread.currentThread().getId();
            long before = threads.getThreadAllocatedBytes(thread);
            for (int i = 0; i < 100; i++) {
                simulation.step();
            }
            long between = threads.getThreadAllocatedBytes(thread);
            for (int i = 0; i < 100; i++) {
                surfaces.capture(frame);
            }
            long after = threads.getThreadAllocatedBytes(thread);
            // A row of observables and a few triples; a scene's positions are 300 kB.
            assertThat((after - between) / 100).isLessThan(4_000);
            // Sine and cosine of the angles of 24 ribs and the sternum.
            assertThat((between - before) / 100).isLessThan(200 + 50 * allocatedBySine(threads));
        }
    }

    /** Bytes that StrictMath allocates for a sine: none in Java 17, an array from Java 21 on. */
    private static long allocatedBySine(ThreadMXBean threads) {
        long thread = Thread.currentThread().getId();
        double sum = 0;
        long before = threads.getThreadAllocatedBytes(thread);
        for (int i = 0; i < 1000; i++) {
            sum += StrictMath.sin(i * 1e-3);
        }
        long bytes = (threads.getThreadAllocatedBytes(thread) - before) / 1000;
        assertThat(sum).isPositive();
        return bytes;
    }

    @Test
    void overlaysShowWhatTheSceneIsMadeOf() {
        try (Simulation physical = Runs.simulation(Runs.scenario());
                Simulation paper = Runs.simulation(Runs.scenario(Runs.sheetAlone("material=paper")))) {
            int nodes = physical.system().nodeCount();
            Map<Overlay.Kind, Overlay> of = byKind(physical);
            assertThat(of).doesNotContainKey(Overlay.Kind.ACTION_LINES);
            assertThat(of.get(Overlay.Kind.SPRINGS).nodePairs())
                    .hasSize(2 * physical.scene().springCount());
            assertThat(of.get(Overlay.Kind.RIGID_LINKS).nodePairs())
                    .hasSize(2 * physical.scene().activeLinks().orElseThrow().count());
            assertThat(of.get(Overlay.Kind.ATTACHMENTS).nodePairs())
                    .hasSize(2 * physical.scene().heldNodes().length);
            assertThat(of.get(Overlay.Kind.FIBRES).nodePairs().length).isGreaterThan(500);
            assertThat(of.values()).allSatisfy(overlay -> assertThat(Arrays.stream(overlay.nodePairs()))
                    .allMatch(node -> node >= 0 && node < nodes));
            // 24 ribs, an axis of two ends each.
            assertThat(of.get(Overlay.Kind.HELICAL_AXES).segments()).hasSize(24 * 6);
            assertThat(byKind(paper).get(Overlay.Kind.ACTION_LINES).segments()).hasSize(2 * 6);
        }
    }

    private static Map<Overlay.Kind, Overlay> byKind(Simulation simulation) {
        return new SceneSurfaces(simulation)
                .overlays().stream().collect(Collectors.toMap(Overlay::kind, Function.identity()));
    }
}
