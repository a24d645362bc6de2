package org.phrenic.access.path;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.TargetMotion;
import org.phrenic.document.OrderedValues;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;

/**
 * Accessibility map of a target: from which skin points, and at which moments of the breath, a straight path reaches
 * it. A path runs from the current position of a skin vertex to the current centre of the target. It is free if it
 * touches no avoided zone, enters the skin from outside and is not longer than the needle.
 *
 * <p>Blocks of vertices are evaluated in parallel. The result does not depend on the number of threads.
 */
public final class AccessMap {
    /** Sufficient margin, mm: of two paths with at least this margin, the shorter is preferred. */
    public static final double SUFFICIENT_MARGIN_MM = 3;

    private static final int BLOCK = 64;
    /** Bit of a path that is longer than the needle or enters the skin from inside. */
    private static final int OUT_OF_REACH = 1 << 30;

    /** Bit of a place of the skin that is no entry. */
    private static final int NO_ENTRY = 1 << 29;
    /** A crossing of the pleura counts as so much longer a path when the best entry is chosen, mm. */
    static final double PLEURA_COST_MM = 30;

    /** Accessibility of the target from a skin point. */
    public enum Access {
        /** Free at every moment of the breath. */
        FREE,
        /** Free at some moments. */
        PART,
        /** Free at no moment. */
        NEVER
    }

    /** Numbers of skin points: all, in reach of the needle at the first moment, and of these by accessibility. */
    public record Counts(int points, int inReach, int free, int part, int never) {
        public OrderedValues toMap() {
            return new OrderedValues()
                    .with("skin_points", points)
                    .with("in_reach", inReach)
                    .with("free", free)
                    .with("in_part", part)
                    .with("never", never);
        }
    }

    private final List<BreathMoment> cycle;
    private final Set<NoGoZone> avoided;
    private final int avoidedBits;
    /** Zones that a path touches, and margin of a free path, mm. Both are indexed by moment and vertex. */
    private final int[][] touched;

    private final float[][] margins;
    /** Smallest margin over the free moments, mm; infinite if the path is never free. */
    private final float[] margin;

    /** Path length by moment and vertex, mm. */
    private final float[][] lengths;

    private final float[] angleDeg;
    private final String[] nearest;
    private final double[][] targets;
    private final TriangleMesh skin;
    private final SkinEntries entries;

    private AccessMap(MovingAnatomy anatomy, List<BreathMoment> cycle, Set<NoGoZone> avoided) {
        this.cycle = List.copyOf(cycle);
        this.avoided = avoided;
        skin = anatomy.skin().surface().rest();
        entries = new SkinEntries(anatomy);
        int n = skin.vertexCount();
        avoidedBits = NoGoZone.bits(avoided) | OUT_OF_REACH | NO_ENTRY;
        touched = new int[cycle.size()][n];
        margins = new float[cycle.size()][n];
        margin = new float[n];
        lengths = new float[cycle.size()][n];
        angleDeg = new float[n];
        nearest = new String[n];
        targets = new double[cycle.size()][];
        Arrays.fill(margin, Float.POSITIVE_INFINITY);
        Arrays.fill(angleDeg, Float.NaN);
        Arrays.fill(nearest, "");
    }

    /** Computes the map. Afterwards the anatomy is at the last moment of the cycle. */
    public static AccessMap of(
            MovingAnatomy anatomy,
            List<BreathMoment> cycle,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided,
            Workers workers) {
        AccessMap map = new AccessMap(anatomy, cycle, avoided);
        LiverTissue tissue = new LiverTissue(anatomy);
        LiverTissue.Point centre = tissue.pointAtRest(target.restMm());
        int blocks = (map.size() + BLOCK - 1) / BLOCK;
        PathAnalyzer[] analyzers = new PathAnalyzer[blocks];
        Arrays.setAll(analyzers, i -> new PathAnalyzer(anatomy, needle));
        List<MovingStructure> structures = anatomy.structures();
        for (int m = 0; m < cycle.size(); m++) {
            int moment = m;
            Frame frame = cycle.get(m).frame();
            workers.run(structures.size(), i -> structures.get(i).update(frame));
            map.targets[m] = tissue.position(centre);
            TriangleMesh skin = map.skin.withPositions(anatomy.skin().positions());
            double[] normals = MeshMeasure.vertexNormals(skin);
            workers.run(blocks, block -> {
                int end = Math.min((block + 1) * BLOCK, map.size());
                for (int v = block * BLOCK; v < end; v++) {
                    map.evaluate(moment, v, skin, normals, analyzers[block], needle);
                }
            });
        }
        anatomy.update(cycle.get(cycle.size() - 1).frame());
        return map;
    }

    private void evaluate(
            int moment, int v, TriangleMesh skinNow, double[] normals, PathAnalyzer analyzer, Needle needle) {
        if (entries.place(v) != SkinEntries.Place.ENTRY) {
            touched[moment][v] = NO_ENTRY;
            return;
        }
        double[] entry = Arrays.copyOfRange(skinNow.positions(), 3 * v, 3 * v + 3);
        double[] target = targets[moment];
        double[] path = Vectors.subtract(target, entry);
        double length = Vectors.length(path);
        lengths[moment][v] = (float) length;
        double inward = -Vectors.dot(path, Arrays.copyOfRange(normals, 3 * v, 3 * v + 3));
        if (needle.isShorterThan(length) || !(inward > 0)) {
            touched[moment][v] = OUT_OF_REACH;
            return;
        }
        touched[moment][v] = analyzer.touched(entry, target);
        if (isFree(moment, v)) {
            PathAnalyzer.Margin found = analyzer.margin(entry, target, avoided);
            margins[moment][v] = (float) found.mm();
            if (margins[moment][v] < margin[v]) {
                margin[v] = margins[moment][v];
                nearest[v] = found.nearest();
                angleDeg[v] = (float) analyzer.capsuleAngle(entry, target);
            }
        }
    }

    /** Number of skin points, which are the vertices of the skin mesh. */
    public int size() {
        return margin.length;
    }

    /** Position of a skin vertex at end-expiration, LPS, mm. */
    public double[] pointAtRest(int vertex) {
        return Arrays.copyOfRange(skin.positions(), 3 * vertex, 3 * vertex + 3);
    }

    /** The moments of the breath for which the map was computed. */
    public List<BreathMoment> cycle() {
        return cycle;
    }

    public Set<NoGoZone> avoided() {
        return avoided;
    }

    /** Centre of the target at a moment, LPS, mm; a copy. */
    public double[] target(int moment) {
        return targets[moment].clone();
    }

    public TargetMotion motion() {
        return new TargetMotion(List.of(targets));
    }

    /** Whether the path from a vertex is free at a moment. */
    public boolean isFree(int moment, int vertex) {
        return (touched[moment][vertex] & avoidedBits) == 0;
    }

    /** Whether a vertex is an entry from which the needle reaches the target at a moment. Obstacles are ignored. */
    public boolean isInReach(int moment, int vertex) {
        return (touched[moment][vertex] & (OUT_OF_REACH | NO_ENTRY)) == 0;
    }

    /** What the place of a vertex is: skin that a needle may enter, or not. */
    public SkinEntries.Place place(int vertex) {
        return entries.place(vertex);
    }

    /** Whether the path from a vertex crosses the pleura at any moment at which it is free. */
    public boolean crossesPleura(int vertex) {
        return IntStream.range(0, touched.length).anyMatch(m -> crossesPleura(m, vertex));
    }

    private boolean crossesPleura(int moment, int vertex) {
        return isFree(moment, vertex) && (touched[moment][vertex] & NoGoZone.PLEURA.bit()) != 0;
    }

    /** Zones that the path touches at a moment; none if the vertex is out of reach. */
    public Set<NoGoZone> touched(int moment, int vertex) {
        return NoGoZone.of(touched[moment][vertex]);
    }

    /** Number of moments at which the path from a vertex is free. */
    public int freeMoments(int vertex) {
        int count = 0;
        for (int m = 0; m < touched.length; m++) {
            count += isFree(m, vertex) ? 1 : 0;
        }
        return count;
    }

    public Access access(int vertex) {
        int free = freeMoments(vertex);
        return free == 0 ? Access.NEVER : free == touched.length ? Access.FREE : Access.PART;
    }

    /**
     * Smallest margin over the moments at which the path is free, mm, at most {@link PathAnalyzer#MAX_DISTANCE_MM}. The
     * value is 0 if the path is never free.
     */
    public double marginMm(int vertex) {
        return Float.isInfinite(margin[vertex]) ? 0 : margin[vertex];
    }

    /** Margin to the avoided zones at a moment, mm; 0 if the path is not free. */
    public double marginMm(int moment, int vertex) {
        return margins[moment][vertex];
    }

    /** Name of the structure that limits the margin; empty if there is none. */
    public String nearest(int vertex) {
        return nearest[vertex];
    }

    /** Largest path length from a vertex over the breath, mm. */
    public double lengthMm(int vertex) {
        float largest = 0;
        for (float[] moment : lengths) {
            largest = Math.max(largest, moment[vertex]);
        }
        return largest;
    }

    /**
     * Angle between path and liver surface at the moment of smallest margin, degrees; 90 is perpendicular, NaN is
     * undefined.
     */
    public double angleDeg(int vertex) {
        return angleDeg[vertex];
    }

    /** Percentage of the breath during which the path from each vertex is free. */
    public float[] freePercent() {
        float[] share = new float[size()];
        for (int v = 0; v < share.length; v++) {
            share[v] = 100f * freeMoments(v) / touched.length;
        }
        return share;
    }

    /**
     * Selects the best entry point. Candidates are the vertices with the most free moments. Among them, vertices with a
     * sufficient margin are preferred, or those with the largest margin if none is sufficient. The shortest path
     * decides; a crossing of the pleura counts as {@value #PLEURA_COST_MM} mm.
     *
     * @return empty if no path is ever free
     */
    public Optional<Integer> best(double sufficientMm) {
        int longest = IntStream.range(0, size()).map(this::freeMoments).reduce(1, Math::max);
        return shortest(
                v -> freeMoments(v) == longest,
                this::marginMm,
                v -> lengthMm(v) + (crossesPleura(v) ? PLEURA_COST_MM : 0),
                sufficientMm);
    }

    /**
     * Like {@link #best} at one moment of the breath: candidates are the vertices whose path is free at it, and its
     * margin, length and crossing of the pleura at this moment decide.
     */
    public Optional<Integer> bestAt(int moment, double sufficientMm) {
        return shortest(
                v -> isFree(moment, v),
                v -> marginMm(moment, v),
                v -> lengths[moment][v] + (crossesPleura(moment, v) ? PLEURA_COST_MM : 0),
                sufficientMm);
    }

    private Optional<Integer> shortest(
            IntPredicate allowed, IntToDoubleFunction margin, IntToDoubleFunction cost, double sufficientMm) {
        int[] candidates = IntStream.range(0, size()).filter(allowed).toArray();
        double largest = IntStream.of(candidates).mapToDouble(margin).max().orElse(0);
        return IntStream.of(candidates)
                .filter(v -> margin.applyAsDouble(v) >= Math.min(largest, sufficientMm))
                .boxed()
                .min(Comparator.comparingDouble(cost::applyAsDouble));
    }

    public Counts counts() {
        int[] count = new int[Access.values().length];
        int reached = 0;
        for (int v = 0; v < size(); v++) {
            if (isInReach(0, v)) {
                count[access(v).ordinal()]++;
                reached++;
            }
        }
        return new Counts(size(), reached, count[0], count[1], count[2]);
    }
}
