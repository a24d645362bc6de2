package org.phrenic.access.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.Side;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Vectors;

/** Access to targets in the coarse virtual adult male in a deep breath that is taken fast, and in a body of boxes. */
class AccessMapTest {
    private static final int INSPIRED = 4;
    /** Places in single precision and a turned axis: what is nearer to a limit than this may fall to either side. */
    private static final double ROUNDING_MM = 2e-4;

    /** A path that passes so near to what it avoids is no way. */
    private static final double GRAZING_MM = 1;

    private static final double[] RIGHT_LOBE = {-90, 0, 50};
    private static final double[] DOME = {-70, 0, 95};
    private static final double[] LOW_IN_FRONT = {-65, -60, 10};
    private static final double[] LEFT_LOBE = {10, -65, 60};

    private static Workers workers;
    private static MovingAnatomy scene;

    @BeforeAll
    static void breathe() {
        workers = Workers.of(2);
        scene = new MovingAnatomy(CoarseBreath.SURFACES);
    }

    @AfterAll
    static void end() {
        workers.close();
    }

    private static AccessMap map(double[] target, Workers on) {
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        return AccessMap.of(
                scene,
                CoarseBreath.CYCLE,
                TargetLesion.at(scene, target, 15),
                Needle.standard(),
                NoGoZone.defaults(),
                on);
    }

    private static Optional<IntercostalSpace> space(AccessMap map, int moment, int vertex) {
        return new PathAnalyzer(scene, Needle.standard())
                .analyze(entry(vertex), map.target(moment))
                .space();
    }

    private static double[] entry(int vertex) {
        return Arrays.copyOfRange(scene.skin().positions(), 3 * vertex, 3 * vertex + 3);
    }

    @Test
    void everyTriangleWithoutATreeSaysTheSameOfEveryPointOfTheSkin() {
        AccessMap map = map(RIGHT_LOBE, workers);
        int asked = 0;
        for (int moment : new int[] {0, INSPIRED}) {
            scene.update(CoarseBreath.CYCLE.get(moment).frame());
            BruteForcePath brute = new BruteForcePath(
                    scene.structures().stream().map(MovingStructure::surface).toList(),
                    CoarseBreath.CYCLE.get(moment).frame(),
                    Needle.standard());
            for (int v = 0; v < map.size(); v++) {
                if (!map.isInReach(moment, v)) {
                    continue;
                }
                asked++;
                Set<NoGoZone> expected = brute.touched(entry(v), map.target(moment));
                Set<NoGoZone> seen = map.touched(moment, v);
                seen.remove(NoGoZone.PLEURA);
                if (brute.slack > ROUNDING_MM) {
                    assertThat(seen).as("vertex " + v + " at moment " + moment).isEqualTo(expected);
                }
            }
        }
        assertThat(asked).isGreaterThan(1200);
    }

    /** Lengths and crossings of other moments, which a breath that is held never has, do not count. */
    @Test
    void theBestAtAMomentIsTheShortestWithMarginThere() {
        for (double[] target : new double[][] {RIGHT_LOBE, DOME}) {
            AccessMap map = map(target, workers);
            for (int moment : new int[] {0, INSPIRED}) {
                scene.update(CoarseBreath.CYCLE.get(moment).frame());
                double[] cost = IntStream.range(0, map.size())
                        .mapToDouble(v -> Vectors.distance(entry(v), map.target(moment))
                                + (map.touched(moment, v).contains(NoGoZone.PLEURA) ? AccessMap.PLEURA_COST_MM : 0))
                        .toArray();
                int best = map.bestAt(moment, AccessMap.SUFFICIENT_MARGIN_MM).orElseThrow();
                double least = IntStream.range(0, map.size())
                        .filter(v -> map.isFree(moment, v) && map.marginMm(moment, v) >= AccessMap.SUFFICIENT_MARGIN_MM)
                        .mapToDouble(v -> cost[v])
                        .min()
                        .orElseThrow();
                assertThat(cost[best]).isCloseTo(least, within(ROUNDING_MM));
            }
        }
    }

    @Test
    void noWayInIsOnACutEndUnderAnArmOrOnTheTableAndWaysAreNamed() {
        AccessMap map = map(RIGHT_LOBE, workers);
        double[] box = scene.skin().surface().rest().bounds();
        double[] normals = MeshMeasure.vertexNormals(scene.skin().surface().rest());
        for (int v = 0; v < map.size(); v++) {
            double z = map.pointAtRest(v)[2];
            if (z < box[2] + 1 || z > box[5] - 1 || normals[3 * v + 1] > 0.8) {
                assertThat(map.place(v)).isNotEqualTo(SkinEntries.Place.ENTRY);
            }
            if (map.place(v) != SkinEntries.Place.ENTRY) {
                assertThat(map.access(v)).isEqualTo(AccessMap.Access.NEVER);
                assertThat(map.isInReach(0, v)).isFalse();
            }
        }
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        PathAnalyzer analyzer = new PathAnalyzer(scene, Needle.standard());
        double[] target = map.target(0);
        assertThat(analyzer.analyze(new double[] {0, -118, 10}, target).way().label())
                .isEqualTo("subxiphoid");
        assertThat(analyzer.analyze(new double[] {-70, -115, -60}, target).way().label())
                .isEqualTo("right subcostal");
        PathAnalysis between = analyzer.analyze(new double[] {-156, 0, 20}, target);
        assertThat(between.way().kind()).isEqualTo(EntryWay.Kind.INTERCOSTAL);
        assertThat(between.crossesPleura()).isTrue();
        assertThat(between.crossing(Crossing.RECESS)).isPresent();
        double[] entry = {-156, 0, 20};
        assertThat(analyzer.margin(entry, target, Set.of(NoGoZone.LUNG)).mm()).isPositive();
        assertThat(analyzer.margin(entry, target, Set.of(NoGoZone.LUNG, NoGoZone.PLEURA))
                        .mm())
                .as("a recess that is crossed and avoided leaves no margin")
                .isZero();
        assertThat(analyzer.analyze(new double[] {-70, -115, -60}, target).crossesPleura())
                .isFalse();
    }

    /** Of the ribs behind which such a way rises, some are above it and some below, for the margin slopes. */
    @Test
    void noWayFromInFrontAndBelowAllRibsIsIntercostal() {
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        double lowest = scene.hazards().stream()
                .filter(PathAnalyzer::isCage)
                .mapToDouble(rib -> rib.box()[2])
                .min()
                .orElseThrow();
        PathAnalyzer analyzer = new PathAnalyzer(scene, Needle.standard());
        int asked = 0;
        for (double[] target : new double[][] {RIGHT_LOBE, LOW_IN_FRONT, LEFT_LOBE}) {
            for (int v = 0; v < scene.skin().positions().length / 3; v++) {
                double[] entry = entry(v);
                if (entry[1] < -90 && entry[2] < lowest && Vectors.distance(entry, target) < 150) {
                    asked++;
                    EntryWay way = analyzer.way(entry, target);
                    assertThat(analyzer.analyze(entry, target).way()).isEqualTo(way);
                    assertThat(way.kind())
                            .as(Arrays.toString(entry) + " to " + Arrays.toString(target))
                            .isNotEqualTo(EntryWay.Kind.INTERCOSTAL);
                }
            }
        }
        assertThat(asked).isGreaterThan(50);
    }

    /**
     * Their place is near one rib, of which the other may lie no lower, and a cartilage of the first higher. The space
     * is that below the upper one of the two ribs that lie nearest to the way.
     */
    @Test
    void anObliqueWayBetweenTwoRibsHasTheNameOfTheirSpace() {
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        PathAnalyzer analyzer = new PathAnalyzer(scene, Needle.standard());
        double[][] entries = {{-136, -74, -49}, {-138, -74, -12}, {-128, -88, 24}, {-130, -87, 60}, {-114, -98, 80}};
        for (double[] entry : entries) {
            EntryWay way = analyzer.way(entry, RIGHT_LOBE);
            assertThat(analyzer.analyze(entry, RIGHT_LOBE).way()).isEqualTo(way);
            assertThat(way.space().map(IntercostalSpace::number))
                    .as(Arrays.toString(entry))
                    .contains(upperOfTheNearestRibs(entry, RIGHT_LOBE));
        }
        assertThat(List.of(entries))
                .extracting(entry -> upperOfTheNearestRibs(entry, RIGHT_LOBE))
                .containsExactly(9, 8, 7, 6, 5);
    }

    /** The number of the upper one of the two ribs on the right whose vertices lie nearest to a path. */
    private static int upperOfTheNearestRibs(double[] entry, double[] target) {
        List<Integer> nearest = IntStream.rangeClosed(1, 12)
                .boxed()
                .sorted(Comparator.comparingDouble(number -> distanceOfRib(number, entry, target)))
                .limit(2)
                .sorted()
                .toList();
        assertThat(nearest.get(1) - nearest.get(0)).as("neighbours").isEqualTo(1);
        return nearest.get(0);
    }

    private static double distanceOfRib(int number, double[] entry, double[] target) {
        String name = String.format(Locale.ROOT, "rib_%02d_R", number);
        double[] rib = scene.hazards().stream()
                .filter(hazard -> hazard.surface().name().equals(name))
                .findFirst()
                .orElseThrow()
                .positions();
        double[] way = Vectors.subtract(target, entry);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < rib.length; i += 3) {
            double[] vertex = Arrays.copyOfRange(rib, i, i + 3);
            double along = Vectors.dot(Vectors.subtract(vertex, entry), way) / Vectors.dot(way, way);
            double[] on = Vectors.addScaled(entry, way, Math.max(0, Math.min(1, along)));
            least = Math.min(least, Vectors.distance(vertex, on));
        }
        return least;
    }

    @Test
    void inABodyOfBoxesTheMapIsThatOfTheBoxes() {
        BoxAnatomy body = new BoxAnatomy();
        MovingAnatomy boxes = new MovingAnatomy(body.surfaces);
        List<BreathMoment> breath = List.of(
                new BreathMoment(body.frame(0, 0, new double[3], 0, 0), RespiratoryPhase.PAUSE, 4),
                new BreathMoment(body.frame(1, 0.5, new double[3], 30, 0), RespiratoryPhase.INSPIRATION, 4));
        TargetLesion target = TargetLesion.at(boxes, new double[] {90, 0, 0}, 10);
        AccessMap map = AccessMap.of(boxes, breath, target, new Needle(18, 300), NoGoZone.defaults(), workers);
        for (int v = 0; v < map.size(); v++) {
            for (int m = 0; m < 2; m++) {
                boxes.update(breath.get(m).frame());
                BruteForcePath brute =
                        new BruteForcePath(body.surfaces, breath.get(m).frame(), new Needle(18, 300));
                double[] from = Arrays.copyOfRange(boxes.skin().positions(), 3 * v, 3 * v + 3);
                Set<NoGoZone> seen = map.touched(m, v);
                assertThat(seen).isEqualTo(brute.touched(from, map.target(m)));
            }
        }
    }

    /** The target comes nearer to some of the skin, of which the shares of the skin in reach say nothing. */
    @Test
    void freePartAndNeverAddUpToThePointsInReachAtTheFirstMoment() {
        AccessMap map = map(RIGHT_LOBE, workers);
        long later = IntStream.range(0, map.size())
                .filter(v -> map.access(v) == AccessMap.Access.PART && !map.isInReach(0, v))
                .count();
        assertThat(later).isPositive();
        AccessMap.Counts counts = map.counts();
        assertThat(counts.inReach()).isLessThan(counts.points());
        assertThat(counts.free() + counts.part() + counts.never()).isEqualTo(counts.inReach());
    }

    @Test
    void theMapDoesNotDependOnThreads() {
        AccessMap two = map(RIGHT_LOBE, workers);
        try (Workers alone = Workers.of(1)) {
            AccessMap one = map(RIGHT_LOBE, alone);
            assertThat(one.freePercent()).isEqualTo(two.freePercent());
            for (int v = 0; v < one.size(); v++) {
                assertThat(one.marginMm(v)).isEqualTo(two.marginMm(v));
                assertThat(one.nearest(v)).isEqualTo(two.nearest(v));
            }
        }
    }

    @Test
    void theMarginIsTheLeastOverTheFreeMoments() {
        AccessMap map = map(RIGHT_LOBE, workers);
        int falling = 0;
        for (int v = 0; v < map.size(); v++) {
            double least = Double.POSITIVE_INFINITY;
            double last = 0;
            for (int moment = 0; moment < map.cycle().size(); moment++) {
                if (map.isFree(moment, v)) {
                    last = map.marginMm(moment, v);
                    least = Math.min(least, last);
                }
            }
            assertThat(map.marginMm(v)).isEqualTo(Double.isInfinite(least) ? 0 : least);
            falling += last > least ? 1 : 0;
        }
        assertThat(falling)
                .as("entries whose last free moment is not the narrowest")
                .isPositive();
    }

    /**
     * Biopsies go in at the 7th to 9th space, mid-axillary line (physiology: emedicine 149684); above, the lung lies in
     * the way, but for a path that grazes the sixth costal cartilage.
     */
    @Test
    void toTheRightLobeTheSeventhToNinthSpacesAreFreeAtExpirationAndThoseAboveTheSixthAreNot() {
        AccessMap map = map(RIGHT_LOBE, workers);
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        PathAnalyzer analyzer = new PathAnalyzer(scene, Needle.standard());
        int[] free = new int[13];
        int[] grazing = new int[13];
        for (int v = 0; v < map.size(); v++) {
            Optional<IntercostalSpace> space = map.isFree(0, v) ? space(map, 0, v) : Optional.empty();
            if (space.isPresent()) {
                assertThat(space.get().side()).isEqualTo(Side.RIGHT);
                int number = space.get().number();
                PathAnalyzer.Margin margin = analyzer.margin(entry(v), map.target(0), NoGoZone.defaults());
                (margin.mm() > GRAZING_MM ? free : grazing)[number]++;
                if (margin.mm() <= GRAZING_MM && number < 6) {
                    assertThat(margin.nearest()).startsWith("costal_cartilage");
                }
            }
        }
        assertThat(Arrays.stream(grazing, 0, 6).sum())
                .as("at the lower edge of the fifth space")
                .isLessThanOrEqualTo(1);
        assertThat(free[7]).isGreaterThan(10);
        assertThat(free[8]).isGreaterThan(10);
        assertThat(free[9]).isGreaterThan(10);
        assertThat(Arrays.copyOf(free, 6)).containsOnly(0);
        assertThat(map.best(5)).isPresent();
    }

    /** The lung comes down into the recess: what was free at the side above it is so no more. */
    @Test
    void toTheDomeTheLungBarsTheSeventhSpaceAtTheSideWhenInspired() {
        AccessMap map = map(DOME, workers);
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        int free = 0;
        for (int v = 0; v < map.size(); v++) {
            double[] entry = entry(v);
            boolean lateral = entry[0] < -100 && Math.abs(entry[1]) < 70;
            if (lateral
                    && map.isFree(0, v)
                    && space(map, 0, v).filter(s -> s.number() <= 7).isPresent()) {
                free++;
                assertThat(map.touched(INSPIRED, v)).contains(NoGoZone.LUNG);
                assertThat(map.access(v)).isEqualTo(AccessMap.Access.PART);
            }
        }
        assertThat(free).isGreaterThan(5);
    }

    @Test
    void pointsOfTheTissueMoveAsTheirNeighbourhoodAndAreFoundAgain() {
        LiverTissue tissue = new LiverTissue(scene);
        scene.update(CoarseBreath.CYCLE.get(0).frame());
        LiverTissue.Point point = tissue.pointAtRest(RIGHT_LOBE);
        scene.update(CoarseBreath.CYCLE.get(INSPIRED).frame());
        double[] now = tissue.position(point);
        double[] back = tissue.pointNowAt(now).rest();
        for (int axis = 0; axis < 3; axis++) {
            assertThat(back[axis]).isCloseTo(RIGHT_LOBE[axis], within(1e-6));
        }
        // A vertex of the surface is where the surface is; soft weights leave it this near.
        int v = 100;
        double[] rest = Arrays.copyOfRange(scene.liver().surface().rest().positions(), 3 * v, 3 * v + 3);
        double[] seen = tissue.position(tissue.pointAtRest(rest));
        double[] vertex = Arrays.copyOfRange(scene.liver().positions(), 3 * v, 3 * v + 3);
        assertThat(Vectors.distance(seen, vertex)).isLessThan(0.5);
    }

    @Test
    void randomTargetsAreRepeatableAndLieWithinTheLiver() {
        int larger = 0;
        for (long seed = 1; seed < 21; seed++) {
            TargetLesion one = TargetLesion.random(scene, seed, Double.NaN);
            assertThat(one.restMm())
                    .isEqualTo(TargetLesion.random(scene, seed, Double.NaN).restMm());
            assertThat(one.diameterMm()).isBetween(8.0, 50.0);
            larger += one.diameterMm() > 23 ? 1 : 0;
        }
        // 57 % of what is drawn between 8 and 50 mm is larger than the mean, 23 mm: of 20 at least 5 and at most 17 in
        // 99.7 % of cases.
        assertThat(larger).isBetween(5, 17);
        assertThat(TargetLesion.randomUpTo(scene, 3, 20).restMm())
                .as("with room, that of this size")
                .isEqualTo(TargetLesion.random(scene, 3, 20).restMm());
    }

    /** In a liver 12 mm thick there is room for 10 mm, in one 3 mm thick for none. */
    @Test
    void aRandomTargetIsTheLargestUsualOneThatHasRoom() {
        double[][] roomAskedFound = {
            {18, 20, 15}, {12, 20, 10}, {12, 9, 9}, {9, 20, 8}, {6, 20, TargetLesion.SMALLEST_MM}
        };
        for (double[] mm : roomAskedFound) {
            TargetLesion largest = TargetLesion.randomUpTo(BoxAnatomy.withLiver(mm[0], 30, 30), 3, mm[1]);
            assertThat(largest.diameterMm()).as("in %.0f mm", mm[0]).isEqualTo(mm[2]);
        }
        MovingAnatomy flat = BoxAnatomy.withLiver(3, 30, 30);
        assertThatThrownBy(() -> TargetLesion.randomUpTo(flat, 3, 20))
                .isInstanceOf(BadInputException.class)
                .hasMessage("target: found no room for a sphere of 5.0 mm within the liver, expected a larger liver");
    }
}
