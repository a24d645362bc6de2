package org.phrenic.access.path;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;

/** The free ways of the left lobe's exercise on a coarse mesh, against every triangle of every surface. */
class FreeWaysTest {
    /** An end of the skin is rounded: the ring around its tip lies 1.1 mm from it along the body, the next 4 mm. */
    private static final double END_MM = 2;

    private static final Set<NoGoZone> SURFACES = EnumSet.of(NoGoZone.LUNG, NoGoZone.BONE, NoGoZone.ORGAN);

    /** Every other moment of the breath. */
    private static final List<BreathMoment> CYCLE = IntStream.range(0, CoarseBreath.MOMENTS)
            .filter(m -> m % 2 == 0)
            .mapToObj(CoarseBreath.CYCLE::get)
            .toList();

    private static MovingAnatomy anatomy;
    private static AccessMap map;

    @BeforeAll
    static void breathe() {
        RehearsalPlan plan = RehearsalPlan.exercises().get(3);
        try (Workers workers = Workers.of(2)) {
            anatomy = new MovingAnatomy(CoarseBreath.SURFACES);
            anatomy.update(CYCLE.get(0).frame());
            map = AccessMap.of(anatomy, CYCLE, plan.target(anatomy), plan.needle(), plan.avoided(), workers);
        }
    }

    private static int[] points(AccessMap.Access access) {
        return IntStream.range(0, map.size())
                .filter(v -> map.access(v) == access && map.isInReach(0, v))
                .toArray();
    }

    /** Structures that the ways from points of the skin pass through, over all moments, and how many ways do. */
    private static int crossing(int[] points, Set<String> names) {
        int ways = 0;
        for (int m = 0; m < CYCLE.size(); m++) {
            BruteForcePath brute = new BruteForcePath(
                    CoarseBreath.SURFACES,
                    map.cycle().get(m).frame(),
                    RehearsalPlan.exercises().get(3).needle());
            anatomy.update(map.cycle().get(m).frame());
            double[] skin = anatomy.skin().positions();
            for (int v : points) {
                double[] from = {skin[3 * v], skin[3 * v + 1], skin[3 * v + 2]};
                Set<String> pierced = brute.pierced(from, map.target(m), SURFACES);
                ways += pierced.isEmpty() ? 0 : 1;
                names.addAll(pierced);
            }
        }
        return ways;
    }

    @Test
    void noWayThatIsFreeOverTheBreathPassesThroughAnyTriangleAtAnyMoment() {
        int[] free = points(AccessMap.Access.FREE);
        Set<String> names = new TreeSet<>();
        assertThat(free).hasSizeGreaterThan(50);
        assertThat(crossing(free, names)).as("ways that cross " + names).isZero();
    }

    /** The check sees what bars the others: nearly all that is never free passes through something. */
    @Test
    void waysThatAreNeverFreePassThroughWhatBarsThem() {
        int[] never = IntStream.of(points(AccessMap.Access.NEVER))
                .filter(v -> v % 16 == 0)
                .toArray();
        Set<String> names = new TreeSet<>();
        assertThat(crossing(never, names)).isGreaterThan(never.length * CYCLE.size() / 2);
        assertThat(names).contains("lung_L", "heart").anyMatch(name -> name.startsWith("rib_"));
    }

    /** Flat ends: triangles of the skin of which all corners lie at its upper or lower end, 72 at each. */
    @Test
    void noFreeEntryIsACornerOfAFlatEndOfTheSkinNorAtItsBackNorBesideTheShoulders() {
        TriangleMesh skin = anatomy.skin().surface().rest();
        double[] box = skin.bounds();
        Set<Integer> ends = new TreeSet<>();
        int[] t = skin.triangles();
        for (int i = 0; i < t.length; i += 3) {
            int k = i;
            if (IntStream.range(0, 3).allMatch(c -> skin.z(t[k + c]) < box[2] + END_MM)
                    || IntStream.range(0, 3).allMatch(c -> skin.z(t[k + c]) > box[5] - END_MM)) {
                ends.addAll(List.of(t[i], t[i + 1], t[i + 2]));
            }
        }
        assertThat(ends).hasSizeGreaterThan(140);
        for (int v = 0; v < map.size(); v++) {
            if (map.access(v) != AccessMap.Access.NEVER) {
                assertThat(ends).doesNotContain(v);
                assertThat(skin.y(v)).as("not on the table, mm").isLessThan(box[4] - 10);
                boolean beside = Math.abs(skin.x(v)) > 150;
                assertThat(beside && skin.z(v) > 180).as("beside a shoulder").isFalse();
            }
        }
    }
}
