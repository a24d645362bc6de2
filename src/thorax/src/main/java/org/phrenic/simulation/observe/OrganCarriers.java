package org.phrenic.simulation.observe;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.mesh.query.PointClusters;

/**
 * The points whose displacements carry organs ({@link OrganMotion}): a sample of the vertices of the surfaces about
 * them, and points that stand still. All are added before an organ is bound; then each frame states where they are.
 */
public final class OrganCarriers {
    /** Points taken of a surface, at most. */
    private static final int SAMPLE = 600;

    /** Sampled vertices of a surface, their places at rest, and the first of them among all points. */
    private record Sampled(int[] vertices, double[] rest, int first) {}

    private final int nearest;
    private final List<Sampled> moving = new ArrayList<>();
    private final List<double[]> movingPoints = new ArrayList<>();
    private final List<double[]> stillPoints = new ArrayList<>();
    private double[] displacement = new double[0];

    /**
     * No carriers yet.
     *
     * @param nearest how many of the points carry a point of an organ. Of few, organs follow what is next to them; of
     *     many, the displacement varies less between places, so that organs between carriers that move differently do
     *     not run into one another
     */
    public OrganCarriers(int nearest) {
        this.nearest = nearest;
    }

    /** How many of the points carry a point of an organ. */
    int nearest() {
        return nearest;
    }

    /**
     * Adds a surface that moves.
     *
     * @param rest vertices at end-expiration, three numbers each, mm
     * @param chosen vertices that may carry organs
     * @return index of the surface in {@link #update}
     */
    public int addMoving(double[] rest, IntPredicate chosen) {
        int[] vertices = sample(rest, chosen, SAMPLE);
        moving.add(new Sampled(vertices, rest.clone(), movingPoints.size()));
        addPoints(rest, vertices, movingPoints);
        displacement = new double[3 * movingPoints.size()];
        return moving.size() - 1;
    }

    /**
     * Adds points of a surface that stands still.
     *
     * @param sample number of points that are taken of it, at most
     */
    public void addStill(double[] rest, int sample) {
        addPoints(rest, sample(rest, v -> true, sample), stillPoints);
    }

    private static int[] sample(double[] rest, IntPredicate chosen, int sample) {
        int[] among = IntStream.range(0, rest.length / 3).filter(chosen).toArray();
        double[] points = new double[3 * among.length];
        for (int i = 0; i < among.length; i++) {
            System.arraycopy(rest, 3 * among[i], points, 3 * i, 3);
        }
        PointClusters clusters = new PointClusters(points, Math.max(1, 2 * among.length / sample));
        int[] vertices = new int[clusters.count()];
        Arrays.setAll(vertices, c -> among[clusters.order()[clusters.start(c)]]);
        return vertices;
    }

    private static void addPoints(double[] rest, int[] vertices, List<double[]> to) {
        for (int v : vertices) {
            to.add(Arrays.copyOfRange(rest, 3 * v, 3 * v + 3));
        }
    }

    /** States where a moving surface is. */
    public void update(int surface, double[] now) {
        Sampled sampled = moving.get(surface);
        int at = 3 * sampled.first;
        for (int v : sampled.vertices) {
            for (int axis = 3 * v; axis < 3 * v + 3; axis++) {
                displacement[at++] = now[axis] - sampled.rest[axis];
            }
        }
    }

    /** Places at rest of the points that move. */
    List<double[]> movingPoints() {
        return movingPoints;
    }

    /** Places of the points that stand still. */
    List<double[]> stillPoints() {
        return stillPoints;
    }

    /** Displacement of each moving point, mm. */
    double[] displacement() {
        return displacement;
    }
}
