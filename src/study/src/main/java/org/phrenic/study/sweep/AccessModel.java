package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;

/**
 * Access to a target in the liver as the model of a study: the motion of the target in a breath, and from which
 * directions a straight way to it is free during the whole breath. Besides the factors of a breath, the place of the
 * target in the box around the liver (shares from the right, the front and below), its diameter and the length of the
 * needle vary.
 */
final class AccessModel implements SweepModel {
    static final String NAME = "access";

    private static final String RIGHT = "target.from_right";
    private static final String FRONT = "target.from_front";
    private static final String BELOW = "target.from_below";
    private static final String DIAMETER = "target.diameter_mm";
    private static final String NEEDLE = "needle.length_mm";
    private static final Map<String, double[]> LIMITS = new LinkedHashMap<>();
    /**
     * Values of factors that a study does not state: a target of 20 mm in the right lobe, clear of the vessels of the
     * virtual bodies, and a needle of 150 mm.
     */
    private static final Map<String, Double> USUAL =
            Map.of(RIGHT, 0.2, FRONT, 0.5, BELOW, 0.5, DIAMETER, 20.0, NEEDLE, 150.0);

    private static final double LONGEST_NEEDLE_MM = 250;
    private static final double SHORTEST_NEEDLE_MM = 50;
    private static final List<String> MAIN = List.of("free_percent", "part_percent", "target_excursion_mm");
    private static final List<String> SERIES = List.of("target_left_mm", "target_back_mm", "target_up_mm");
    private static final double PERCENT = 100;

    static {
        for (String share : List.of(RIGHT, FRONT, BELOW)) {
            LIMITS.put(share, new double[] {0, 1});
        }
        LIMITS.put(DIAMETER, new double[] {TargetLesion.SMALLEST_MM, TargetLesion.LARGEST_MM});
        LIMITS.put(NEEDLE, new double[] {SHORTEST_NEEDLE_MM, LONGEST_NEEDLE_MM});
    }

    private final SceneFactors factors;

    AccessModel(SceneFactors factors) {
        this.factors = factors;
    }

    @Override
    public List<String> responses() {
        List<String> all = new ArrayList<>(MAIN);
        all.addAll(WaySectors.columns());
        return all;
    }

    @Override
    public int analysed() {
        return MAIN.size();
    }

    @Override
    public List<String> series() {
        return SERIES;
    }

    @Override
    public double[] limits(String key) {
        return LIMITS.containsKey(key) ? LIMITS.get(key).clone() : factors.limits(key);
    }

    @Override
    public void check(String key, String value) {
        double[] limits = LIMITS.get(key);
        if (limits == null) {
            factors.check(key, value);
            return;
        }
        double number = Numbers.parse(value).orElse(Double.NaN);
        if (!(number >= limits[0] && number <= limits[1])) {
            throw new IllegalArgumentException(
                    "factor '" + key + "': found '" + value + "', expected " + limits[0] + " to " + limits[1]);
        }
    }

    @Override
    public List<String> traitNames() {
        return factors.traitNames();
    }

    @Override
    public List<String> traits(SweepPoint point) {
        return factors.traits(point);
    }

    private static double value(SweepPoint point, String key) {
        int at = point.keys().indexOf(key);
        return at < 0 ? USUAL.get(key) : Numbers.parse(point.values().get(at)).orElseThrow();
    }

    @Override
    public SweepOutcome evaluate(SweepPoint point) {
        try (Simulation simulation = simulation(point)) {
            AccessMap map = map(simulation, point);
            AccessMap.Counts counts = map.counts();
            if (counts.inReach() == 0) {
                throw new IllegalStateException("found no point of the skin in reach of the needle, expected some");
            }
            double[] main = {
                PERCENT * counts.free() / counts.inReach(),
                PERCENT * counts.part() / counts.inReach(),
                map.motion().excursionMm()
            };
            double[] all = DoubleStream.concat(DoubleStream.of(main), DoubleStream.of(WaySectors.free(map)))
                    .toArray();
            return new SweepOutcome(all, simulation.stateHash(), motion(map));
        }
    }

    /** The breath of a point, at rest. */
    Simulation simulation(SweepPoint point) {
        Scenario run = factors.scenario(point);
        return Simulation.of(run, factors.body(point, run));
    }

    /** Runs the breath of a point and computes the ways past all structures and further organs of its body. */
    static AccessMap map(Simulation simulation, SweepPoint point) {
        try (Workers workers = Workers.of(1)) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            MovingAnatomy anatomy = new MovingAnatomy(surfaces.surfaces());
            anatomy.update(surfaces.newFrame());
            TargetLesion target = target(anatomy, point);
            List<BreathMoment> cycle = BreathCycle.record(simulation, surfaces, BreathCycle.PHASES);
            Needle needle = new Needle(Needle.standard().gauge(), value(point, NEEDLE));
            return AccessMap.of(anatomy, cycle, target, needle, NoGoZone.defaults(), workers);
        }
    }

    private static TargetLesion target(MovingAnatomy anatomy, SweepPoint point) {
        double[] box = anatomy.liver().surface().rest().bounds();
        double[] shares = {value(point, RIGHT), value(point, FRONT), value(point, BELOW)};
        double[] at = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = box[axis] + shares[axis] * (box[axis + 3] - box[axis]);
        }
        return TargetLesion.at(anatomy, at, value(point, DIAMETER));
    }

    /** Displacement of the target along LPS axes from end-expiration, through the breath and back to its beginning. */
    private static double[][] motion(AccessMap map) {
        int moments = map.cycle().size();
        double[][] motion = new double[SERIES.size()][SweepOutcome.SERIES_POINTS];
        for (int i = 0; i < SweepOutcome.SERIES_POINTS; i++) {
            double at = (double) i * moments / (SweepOutcome.SERIES_POINTS - 1);
            int before = Math.min((int) at, moments - 1);
            double[] from = map.target(before);
            double[] to = map.target((before + 1) % moments);
            for (int axis = 0; axis < motion.length; axis++) {
                motion[axis][i] = from[axis] + (at - before) * (to[axis] - from[axis]) - map.target(0)[axis];
            }
        }
        return motion;
    }
}
