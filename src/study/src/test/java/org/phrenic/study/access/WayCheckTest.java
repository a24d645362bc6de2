package org.phrenic.study.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

/** Segments and a triangle in the plane z = 0 with corners (0, 0), (4, 0), (0, 4). */
class WayCheckTest {
    private static final double[] CORNERS = {0, 0, 0, 4, 0, 0, 0, 4, 0};

    private static final double[] IN_LIVER = {-90, 0, 50};

    private static boolean isCrossed(double... path) {
        return WayCheck.isCrossed(path, CORNERS, 0, 3, 6);
    }

    @Test
    void aWayCrossesWhatLiesBetweenItsEnds() {
        assertThat(isCrossed(1, 1, 5, 1, 1, -5)).isTrue();
        assertThat(isCrossed(1, 1, -5, 1, 1, 5)).as("from below").isTrue();
        assertThat(isCrossed(1, 1, 5, 1, 1, 1)).as("ends above").isFalse();
        assertThat(isCrossed(3, 3, 5, 3, 3, -5)).as("passes beside").isFalse();
        assertThat(isCrossed(-1, 1, 5, 3, 1, -5)).as("oblique").isTrue();
        assertThat(isCrossed(0, 0, 1, 0, 0, -1)).as("through a corner").isTrue();
        assertThat(isCrossed(10, 10, 0, 20, 11, 0)).as("in the plane").isFalse();
        assertThat(isCrossed(1, 1, 5, 1, 1, 0)).as("ends in it").isTrue();
    }

    /** The skin about two closed bones about the liver, of which the map knows neither bone. */
    @Test
    void aWayThroughTwoSurfacesIsOneThatCrosses() {
        List<Surface> body = List.of(scaled(StructureKind.SKIN, "skin", 3), scaled(StructureKind.LIVER, "liver", 1));
        MovingAnatomy anatomy = new MovingAnatomy(body);
        BreathMoment still = still(body);
        List<Surface> withBones = new ArrayList<>(body);
        withBones.add(scaled(StructureKind.BONE, "inner", 1.5));
        withBones.add(scaled(StructureKind.BONE, "outer", 2));
        try (Workers workers = Workers.of(1)) {
            anatomy.update(still.frame());
            AccessMap map = map(anatomy, still, NoGoZone.defaults(), workers);
            WayCheck check = WayCheck.of(withBones, map);
            assertThat(check.ways()).isPositive();
            assertThat(check.crossing()).isEqualTo(check.ways());
            assertThat(check.crossed()).isEqualTo(Map.of("inner", check.ways(), "outer", check.ways()));
            assertThat(check.passes()).isFalse();
            WayCheck bonesAllowed = WayCheck.of(withBones, map(anatomy, still, EnumSet.of(NoGoZone.LUNG), workers));
            assertThat(bonesAllowed.ways()).isPositive();
            assertThat(bonesAllowed.crossing())
                    .as("of what a plan does not avoid")
                    .isZero();
        }
    }

    /** A tower that is wider than high: the four corners of either end, and none of those between them. */
    @Test
    void bothFlatEndsOfASkinAreCut() {
        double[] p = new double[3 * 12];
        for (int v = 0; v < 12; v++) {
            int corner = v % 4;
            p[3 * v] = corner == 1 || corner == 2 ? 200 : -200;
            p[3 * v + 1] = corner < 2 ? -100 : 100;
            p[3 * v + 2] = 50 * (v / 4);
        }
        List<Integer> t = new ArrayList<>(List.of(0, 2, 1, 0, 3, 2, 8, 9, 10, 8, 10, 11));
        for (int v = 0; v < 8; v++) {
            int next = v % 4 == 3 ? v - 3 : v + 1;
            t.addAll(List.of(v, next, next + 4, v, next + 4, v + 4));
        }
        TriangleMesh tower =
                new TriangleMesh(p, t.stream().mapToInt(Integer::intValue).toArray());
        boolean f = false;
        boolean e = true;
        assertThat(WayCheck.cutEnd(tower)).containsExactly(e, e, e, e, f, f, f, f, e, e, e, e);
    }

    /** A map from a skin without a flat end, held against one that is cut above the target. */
    @Test
    void anEntryOnACutEndFailsTheCheck() {
        List<Surface> body = List.of(scaled(StructureKind.SKIN, "skin", 3), scaled(StructureKind.LIVER, "liver", 1));
        MovingAnatomy anatomy = new MovingAnatomy(body);
        BreathMoment still = still(body);
        double[] cut = body.get(0).rest().positions().clone();
        for (int i = 2; i < cut.length; i += 3) {
            cut[i] = Math.min(cut[i], IN_LIVER[2] + 60);
        }
        TriangleMesh flat = body.get(0).rest().withPositions(cut);
        Surface skin =
                new Surface("skin", StructureKind.SKIN, 0, Side.MIDLINE, flat, Surface.Motion.STILL, new boolean[0]);
        try (Workers workers = Workers.of(1)) {
            anatomy.update(still.frame());
            AccessMap map = map(anatomy, still, NoGoZone.defaults(), workers);
            WayCheck whole = WayCheck.of(body, map);
            assertThat(whole.entries()).isEqualTo(whole.ways());
            assertThat(whole.atCutEnd()).isZero();
            assertThat(whole.passes()).isTrue();
            WayCheck check = WayCheck.of(List.of(skin, body.get(1)), map);
            boolean[] end = WayCheck.cutEnd(flat);
            int expected = (int) IntStream.range(0, map.size())
                    .filter(v -> map.access(v) != AccessMap.Access.NEVER && end[v])
                    .count();
            assertThat(check.crossed()).isEmpty();
            assertThat(check.atCutEnd()).isEqualTo(expected).isBetween(1, check.entries() - 1);
            assertThat(check.passes()).isFalse();
        }
    }

    private static BreathMoment still(List<Surface> body) {
        double[] liver = body.get(1).rest().positions();
        return new BreathMoment(TestFrames.of(body, 0, 0, 0, new double[0], liver), RespiratoryPhase.PAUSE, 4);
    }

    private static AccessMap map(MovingAnatomy anatomy, BreathMoment still, Set<NoGoZone> avoided, Workers workers) {
        return AccessMap.of(
                anatomy, List.of(still), TargetLesion.at(anatomy, IN_LIVER, 10), new Needle(18, 300), avoided, workers);
    }

    /** The liver of the virtual man, so many times as large about a place in it. */
    private static Surface scaled(StructureKind kind, String name, double times) {
        TriangleMesh liver = VirtualThorax.ofPreset("adult-male", Resolution.LOW)
                .structuresOf(StructureKind.LIVER)
                .get(0)
                .mesh();
        double[] p = liver.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] = IN_LIVER[i % 3] + times * (p[i] - IN_LIVER[i % 3]);
        }
        Surface.Motion motion = kind == StructureKind.LIVER ? Surface.Motion.DEFORMING : Surface.Motion.STILL;
        return new Surface(name, kind, 0, Side.MIDLINE, liver.withPositions(p), motion, new boolean[0]);
    }

    /** Where a random segment meets the plane says the same, away from the edges. */
    @Test
    void theSameAsThePointInThePlane() {
        Random random = new Random(1);
        int inside = 0;
        for (int i = 0; i < 20_000; i++) {
            double[] path = random.doubles(6, -6, 6).toArray();
            double s = path[2] / (path[2] - path[5]);
            double x = path[0] + s * (path[3] - path[0]);
            double y = path[1] + s * (path[4] - path[1]);
            boolean expected = s >= 0 && s <= 1 && x >= 0 && y >= 0 && x + y <= 4;
            assertThat(isCrossed(path)).isEqualTo(expected);
            inside += expected ? 1 : 0;
        }
        assertThat(inside).isGreaterThan(500);
    }
}
