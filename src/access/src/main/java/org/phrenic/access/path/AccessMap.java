package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.LiverTissue;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.TargetMotion;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * From where on the skin a target can be reached by a straight path, and in which part of the breath. At each moment
 * the path goes from where the skin's vertex is then to where the target's middle is then; it is free if it touches
 * nothing that is to be avoided, enters the skin from outside, and is no longer than the needle.
 *
 * <p>The trees of the scene are refitted to each moment; the points of the skin are shared out in blocks. The result
 * does not depend on the number of threads.
 */
public final class AccessMap {
    private static final int BLOCK = 64;

    /** Whether a point of the skin gives access. */
    public enum Access {
        /** At every moment of the breath. */
        FREE,
        /** At some. */
        PART,
        /** At none. */
        NEVER
    }

    /** A path that is too long for the needle, or comes from within. */
    private static final int OUT_OF_REACH = 1 << 30;

    private final List<BreathMoment> cycle;
    private final Set<NoGoZone> avoided;
    private final int avoidedBits;
    /** What the path touches, a row a moment, a number a vertex. */
    private final int[][] touched;
    /** Margin of a free path, mm; 0 where it is not free; a row a moment. */
    private final float[][] margins;

    /** Smallest margin over the free moments, mm; infinite where there is none. */
    private final float[] margin;

    private final float[] lengthMm;
    private final float[] angleDeg;
    private final String[] nearest;
    private final double[][] targets;
    private final TriangleMesh skin;

    private AccessMap(MovingAnatomy scene, List<BreathMoment> cycle, Set<NoGoZone> avoided) {
        this.cycle = List.copyOf(cycle);
        this.avoided = avoided;
        skin = scene.skin().surface().rest();
        int n = skin.vertexCount();
        avoidedBits = NoGoZone.bits(avoided) | OUT_OF_REACH;
        touched = new int[cycle.size()][n];
        margins = new float[cycle.size()][n];
        margin = new float[n];
        lengthMm = new float[n];
        angleDeg = new float[n];
        nearest = new String[n];
        targets = new double[cycle.size()][];
        Arrays.fill(margin, Float.POSITIVE_INFINITY);
        Arrays.fill(angleDeg, Float.NaN);
        Arrays.fill(nearest, "");
    }

    /**
     * Works the map out.
     *
     * @param scene of the surfaces of the cycle; afterwards it shows the last moment
     * @param cycle moments of a breath, such as those of {@link BreathCycle#record}
     * @param avoided what a path may not touch
     * @param workers threads to share the work
     */
    public static AccessMap of(
            MovingAnatomy scene,
            List<BreathMoment> cycle,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided,
            Workers workers) {
        AccessMap map = new AccessMap(scene, cycle, avoided);
        LiverTissue tissue = new LiverTissue(scene);
        LiverTissue.Point middle = tissue.pointAtRest(target.restMm());
        int blocks = (map.margin.length + BLOCK - 1) / BLOCK;
        PathAnalyzer[] readers = new PathAnalyzer[blocks];
        Arrays.setAll(readers, i -> new PathAnalyzer(scene, needle));
        List<MovingStructure> structures = scene.structures();
        for (int m = 0; m < cycle.size(); m++) {
            int moment = m;
            workers.run(
                    structures.size(),
                    i -> structures.get(i).update(cycle.get(moment).frame()));
            map.targets[m] = tissue.position(middle);
            double[] normals = MeshMeasure.vertexNormals(
                    map.skin.withPositions(scene.skin().positions()));
            workers.run(blocks, block -> {
                int end = Math.min((block + 1) * BLOCK, map.margin.length);
                for (int v = block * BLOCK; v < end; v++) {
                    map.evaluate(moment, v, scene.skin().positions(), normals, readers[block], needle);
                }
            });
        }
        scene.update(cycle.get(cycle.size() - 1).frame());
        return map;
    }

    private void evaluate(int moment, int v, double[] skinNow, double[] normals, PathAnalyzer reader, Needle needle) {
        double[] entry = Arrays.copyOfRange(skinNow, 3 * v, 3 * v + 3);
        double[] target = targets[moment];
        double[] path = Vectors.subtract(target, entry);
        double length = Vectors.length(path);
        lengthMm[v] = Math.max(lengthMm[v], (float) length);
        double inward = -Vectors.dot(path, Arrays.copyOfRange(normals, 3 * v, 3 * v + 3));
        if (length > needle.lengthMm() || !(inward > 0)) {
            touched[moment][v] = OUT_OF_REACH;
            return;
        }
        touched[moment][v] = reader.touched(entry, target);
        if ((touched[moment][v] & avoidedBits) == 0) {
            float m = (float) reader.margin(entry, target, avoided);
            margins[moment][v] = m;
            if (m < margin[v]) {
                margin[v] = m;
                nearest[v] = reader.nearestOfMargin();
                angleDeg[v] = (float) reader.capsuleAngle(entry, target);
            }
        }
    }

    /** How many points of the skin: the vertices of its mesh. */
    public int size() {
        return margin.length;
    }

    /** A vertex of the skin at end-expiration, LPS, mm. */
    public double[] pointAtRest(int vertex) {
        return Arrays.copyOfRange(skin.positions(), 3 * vertex, 3 * vertex + 3);
    }

    /** The moments of the breath. */
    public List<BreathMoment> cycle() {
        return cycle;
    }

    /** What a path may not touch. */
    public Set<NoGoZone> avoided() {
        return avoided;
    }

    /** Where the target's middle is at a moment; a copy. */
    public double[] target(int moment) {
        return targets[moment].clone();
    }

    /** How the target moves over the breath. */
    public TargetMotion motion() {
        return new TargetMotion(List.of(targets));
    }

    /** Whether the path from a vertex of the skin is free at a moment. */
    public boolean isFree(int moment, int vertex) {
        return (touched[moment][vertex] & avoidedBits) == 0;
    }

    /** Whether the needle reaches the target from a vertex at a moment, whatever is in between. */
    public boolean isInReach(int moment, int vertex) {
        return (touched[moment][vertex] & OUT_OF_REACH) == 0;
    }

    /** What the path touches at a moment. */
    public Set<NoGoZone> touched(int moment, int vertex) {
        return NoGoZone.of(touched[moment][vertex]);
    }

    /** At how many moments the path from a vertex is free. */
    public int freeMoments(int vertex) {
        int count = 0;
        for (int m = 0; m < touched.length; m++) {
            count += isFree(m, vertex) ? 1 : 0;
        }
        return count;
    }

    /** Whether a vertex gives access. */
    public Access access(int vertex) {
        int free = freeMoments(vertex);
        return free == 0 ? Access.NEVER : free == touched.length ? Access.FREE : Access.PART;
    }

    /**
     * The moments at which the path is free, as runs from the first to the last moment of each; a run may go on over
     * the end of the breath into its beginning.
     */
    public List<SafeWindow> windows(int vertex) {
        List<SafeWindow> windows = new ArrayList<>();
        int n = touched.length;
        for (int m = 0; m < n; m++) {
            if (isFree(m, vertex) && !isFree((m + n - 1) % n, vertex)) {
                int end = m;
                while (isFree((end + 1) % n, vertex)) {
                    end++;
                }
                windows.add(new SafeWindow(m, end % n, end - m + 1));
            }
        }
        if (windows.isEmpty() && n > 0 && isFree(0, vertex)) {
            windows.add(new SafeWindow(0, n - 1, n));
        }
        return windows;
    }

    /**
     * Smallest distance from what is to be avoided, over the moments at which the path is free, mm, at most
     * {@link PathAnalyzer#MAX_DISTANCE_MM}; 0 where it never is.
     */
    public double marginMm(int vertex) {
        return Float.isInfinite(margin[vertex]) ? 0 : margin[vertex];
    }

    /** Distance from what is to be avoided at a moment, mm; 0 where the path is not free then. */
    public double marginMm(int moment, int vertex) {
        return margins[moment][vertex];
    }

    /** The structure that the margin is taken from; empty for none. */
    public String nearest(int vertex) {
        return nearest[vertex];
    }

    /** Length of the longest path from a vertex over the breath, mm. */
    public double lengthMm(int vertex) {
        return lengthMm[vertex];
    }

    /** Angle to the liver's surface where the margin is smallest, degrees, 90 straight in; NaN where there is none. */
    public double angleDeg(int vertex) {
        return angleDeg[vertex];
    }

    /** Share of the breath in which each vertex gives access, per cent: what the map is coloured by. */
    public float[] freePercent() {
        float[] share = new float[size()];
        for (int v = 0; v < share.length; v++) {
            share[v] = 100f * freeMoments(v) / touched.length;
        }
        return share;
    }

    /**
     * The vertex that a path is best begun at: of those that are free longest, and of these of such with at least
     * {@code roomMm} of margin or the greatest there is, that with the shortest path.
     *
     * @return empty if no vertex is ever free
     */
    public Optional<Integer> best(double roomMm) {
        int longest = Math.max(
                1, IntStream.range(0, size()).map(this::freeMoments).max().orElse(0));
        return shortest(v -> freeMoments(v) == longest, this::marginMm, roomMm);
    }

    /** As {@link #best}, of the vertices that are free at a moment, however short. */
    public Optional<Integer> bestAt(int moment, double roomMm) {
        return shortest(v -> isFree(moment, v), v -> marginMm(moment, v), roomMm);
    }

    private Optional<Integer> shortest(IntPredicate allowed, IntToDoubleFunction room, double roomMm) {
        double most = IntStream.range(0, size())
                .filter(allowed)
                .mapToDouble(room)
                .max()
                .orElse(0);
        return IntStream.range(0, size())
                .filter(v -> allowed.test(v) && room.applyAsDouble(v) >= Math.min(most, roomMm))
                .boxed()
                .min(Comparator.comparingDouble(this::lengthMm));
    }

    /** How many vertices give access, in part or never; of those in reach of the needle, and of all. */
    public Map<String, Object> counts() {
        Map<String, Object> map = new LinkedHashMap<>();
        int[] count = new int[Access.values().length];
        int reached = 0;
        for (int v = 0; v < size(); v++) {
            count[access(v).ordinal()]++;
            reached += isInReach(0, v) ? 1 : 0;
        }
        map.put("skin_points", size());
        map.put("in_reach", reached);
        map.put("free", count[0]);
        map.put("in_part", count[1]);
        map.put("never", count[2]);
        return map;
    }
}
