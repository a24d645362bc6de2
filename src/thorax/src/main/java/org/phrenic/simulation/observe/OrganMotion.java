package org.phrenic.simulation.observe;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.KthSelector;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.PointClusters;

/**
 * Motion of an organ that the model does not simulate, for display, images and needle paths: it affects neither forces
 * nor observables. Each point is displaced by a weighted mean of the displacements of the nearest points of its
 * carriers ({@link OrganCarriers#nearest}), by Shepard's method with the weights of Franke and Little:
 *
 * <pre>
 * x = X + f(d) H Σ w_i (y_i - Y_i) / Σ w_i,   w_i = ((1 - r_i / R) / (r_i² + s²))²
 * </pre>
 *
 * {@code r_i} is the distance from carrier point i and {@code R} that of the farthest of them, whose weight is 0;
 * {@code s} is {@value #SOFTENING_MM} mm. The displacement is a continuous function of the place at rest, so organs
 * with the same carriers keep clear of one another as far as it varies slowly. {@code d} is the distance from the
 * carriers; {@code f} is 1 up to {@value #WITH_CARRIER_MM} mm and falls to 0 over the next {@value #FADE_MM} mm: organs
 * of the pelvis stand still. {@code H} is the hold of what stands still, at a distance e: {@code d² / (d² + e²)} is
 * what it takes away, from all components, or from the horizontal ones alone for an organ that slides along it. The
 * constants are chosen, not fitted.
 */
public final class OrganMotion {
    /** How an organ is held by what stands still. */
    public enum Hold {
        /** It is fixed there. */
        FIXED,
        /** It slides up and down along it. */
        SLIDING
    }

    private static final double SOFTENING_MM = 5;
    private static final double WITH_CARRIER_MM = 30;
    private static final double FADE_MM = 200;

    private final double[] rest;
    private final OrganCarriers carriers;
    private final boolean sliding;
    private final int count;
    private final int[] nearest;
    private final float[] weights;
    /** Factor of the horizontal components of each point. */
    private final double[] horizontal;

    private final double[] position;
    private Optional<KeptVolume> kept = Optional.empty();

    /**
     * Binds an organ to its carriers.
     *
     * @param rest points of the organ at end-expiration, mm
     */
    public OrganMotion(double[] rest, OrganCarriers carriers, Hold hold) {
        this.rest = rest;
        this.carriers = carriers;
        sliding = hold == Hold.SLIDING;
        count = Math.min(carriers.nearest(), carriers.movingPoints().size());
        nearest = new int[rest.length / 3 * count];
        weights = new float[nearest.length];
        horizontal = new double[rest.length / 3];
        position = rest.clone();
        PointClusters clusters = new PointClusters(rest);
        IntStream.range(0, clusters.count()).parallel().forEach(cluster -> bind(clusters, cluster));
    }

    /**
     * Lets the organ keep its volume where its carriers move apart ({@link KeptVolume}); one without an inside does
     * not.
     *
     * @param mesh the organ at end-expiration
     */
    public OrganMotion keepingVolume(TriangleMesh mesh) {
        kept = MeshMeasure.hasInside(mesh) ? Optional.of(new KeptVolume(mesh)) : Optional.empty();
        return this;
    }

    /** Binds the points of a cluster. Only carriers that can be among the nearest of one of them are looked at. */
    private void bind(PointClusters clusters, int cluster) {
        int[] order = clusters.order();
        int from = clusters.start(cluster);
        int to = clusters.start(cluster + 1);
        double[] centre = Arrays.copyOfRange(rest, 3 * order[from], 3 * order[from] + 3);
        double radius = 0;
        for (int i = from; i < to; i++) {
            radius = Math.max(radius, distance(order[i], centre));
        }
        int[] near = within(carriers.movingPoints(), centre, count, 2 * radius);
        int[] held = within(carriers.stillPoints(), centre, 1, 2 * radius);
        for (int i = from; i < to; i++) {
            bind(order[i], near, held);
        }
    }

    /** The points that are no more than {@code beyond} farther from a place than the nth nearest. */
    private static int[] within(List<double[]> points, double[] place, int n, double beyond) {
        double[] distances =
                points.stream().mapToDouble(p -> Vectors.distance(p, place)).toArray();
        double limit = distances.length == 0 ? 0 : nth(distances, n) + beyond;
        return IntStream.range(0, distances.length)
                .filter(c -> distances[c] <= limit)
                .toArray();
    }

    /** The nth least of some distances. */
    private static double nth(double[] distances, int n) {
        return new KthSelector().select(distances.clone(), null, n - 1);
    }

    private double distance(int point, double[] to) {
        double dx = rest[3 * point] - to[0];
        double dy = rest[3 * point + 1] - to[1];
        double dz = rest[3 * point + 2] - to[2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    private void bind(int point, int[] near, int[] held) {
        double[] distances = new double[near.length];
        Arrays.setAll(distances, i -> distance(point, carriers.movingPoints().get(near[i])));
        double least = Double.POSITIVE_INFINITY;
        for (double r : distances) {
            least = Math.min(least, r);
        }
        // Just beyond the farthest, so that equally distant carriers have weights.
        double radius = nth(distances, count) * (1 + 1e-9) + 1e-9;
        double still = Double.POSITIVE_INFINITY;
        for (int h : held) {
            still = Math.min(still, distance(point, carriers.stillPoints().get(h)));
        }
        double free = Double.isInfinite(still) ? 1 : still * still / (still * still + least * least + 1e-9);
        double share = FallOff.at(Math.max(0, least - WITH_CARRIER_MM), FADE_MM) * (sliding ? 1 : free);
        horizontal[point] = sliding ? free : 1;
        double sum = 0;
        for (double r : distances) {
            sum += r < radius ? weight(r, radius) : 0;
        }
        int k = count * point;
        for (int i = 0; i < near.length && k < count * (point + 1); i++) {
            if (distances[i] < radius) {
                nearest[k] = 3 * near[i];
                weights[k++] = (float) (share * weight(distances[i], radius) / sum);
            }
        }
    }

    private static double weight(double r, double radius) {
        double w = (1 - r / radius) / (r * r + SOFTENING_MM * SOFTENING_MM);
        return w * w;
    }

    /** Positions of the organ where its carriers are now; valid until the next call. Allocates nothing. */
    public double[] now() {
        for (int point = 0; point < horizontal.length; point += 2) {
            displace(point, Math.min(point + 1, horizontal.length - 1));
        }
        kept.ifPresent(volume -> volume.apply(position));
        return position;
    }

    /** Displaces two points, whose sums overlap in the processor; that of one waits for each addition. */
    private void displace(int a, int b) {
        double[] moved = carriers.displacement();
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        int toB = count * (b - a);
        for (int k = count * a; k < count * (a + 1); k++) {
            double w = weights[k];
            int c = nearest[k];
            ax += w * moved[c];
            ay += w * moved[c + 1];
            az += w * moved[c + 2];
            w = weights[k + toB];
            c = nearest[k + toB];
            bx += w * moved[c];
            by += w * moved[c + 1];
            bz += w * moved[c + 2];
        }
        place(a, ax, ay, az);
        place(b, bx, by, bz);
    }

    private void place(int point, double x, double y, double z) {
        position[3 * point] = rest[3 * point] + horizontal[point] * x;
        position[3 * point + 1] = rest[3 * point + 1] + horizontal[point] * y;
        position[3 * point + 2] = rest[3 * point + 2] + z;
    }
}
