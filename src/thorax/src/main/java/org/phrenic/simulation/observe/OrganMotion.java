package org.phrenic.simulation.observe;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.engine.force.FallOff;

/**
 * Motion of an organ that the model does not simulate, for display and for needle paths: it affects neither forces nor
 * observables. Each point is displaced by a weighted mean of the displacements of the {@value #NEAREST} nearest points
 * of a carrier, the diaphragm or the liver:
 *
 * <pre>
 * x = X + f(d) Σ w_i (y_i - Y_i) / Σ w_i,   w_i = 1 / (|X - Y_i|² + s²)²
 * </pre>
 *
 * {@code d} is the distance from the carrier, {@code s} is {@value #SOFTENING_MM} mm. {@code f} is 1 up to
 * {@value #WITH_CARRIER_MM} mm and falls to 0 over the next {@value #FADE_MM} mm: organs of the pelvis stand still. The
 * constants are chosen, not fitted.
 */
public final class OrganMotion {
    private static final int NEAREST = 24;
    private static final double SOFTENING_MM = 25;
    private static final double WITH_CARRIER_MM = 30;
    private static final double FADE_MM = 200;

    private final double[] rest;
    private final double[] carrierRest;
    private final int[] carriers;
    private final double[] weights;
    private final double[] position;

    /**
     * Binds an organ to a carrier.
     *
     * @param rest points of the organ at end-expiration, mm
     * @param carrierRest points of the carrier at end-expiration, mm
     */
    public OrganMotion(double[] rest, double[] carrierRest) {
        this.rest = rest;
        this.carrierRest = carrierRest.clone();
        int count = Math.min(NEAREST, carrierRest.length / 3);
        carriers = new int[rest.length / 3 * count];
        weights = new double[carriers.length];
        position = rest.clone();
        IntStream.range(0, rest.length / 3).parallel().forEach(point -> bind(point, count));
    }

    private void bind(int point, int count) {
        int first = count * point;
        double[] squares = new double[count];
        Arrays.fill(squares, Double.POSITIVE_INFINITY);
        int farthest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < carrierRest.length; c += 3) {
            double dx = carrierRest[c] - rest[3 * point];
            double dy = carrierRest[c + 1] - rest[3 * point + 1];
            double dz = carrierRest[c + 2] - rest[3 * point + 2];
            double square = dx * dx + dy * dy + dz * dz;
            if (square < squares[farthest]) {
                squares[farthest] = square;
                carriers[first + farthest] = c / 3;
                least = Math.min(least, square);
                for (int k = 0; k < count; k++) {
                    farthest = squares[k] > squares[farthest] ? k : farthest;
                }
            }
        }
        double sum = 0;
        for (int k = 0; k < count; k++) {
            double soft = squares[k] + SOFTENING_MM * SOFTENING_MM;
            weights[first + k] = 1 / (soft * soft);
            sum += weights[first + k];
        }
        double share = FallOff.at(Math.max(0, Math.sqrt(least) - WITH_CARRIER_MM), FADE_MM);
        for (int k = 0; k < count; k++) {
            weights[first + k] *= share / sum;
        }
    }

    /** Positions of the organ for positions of the carrier; valid until the next call. Allocates nothing. */
    public double[] at(double[] carrier) {
        int count = 3 * carriers.length / rest.length;
        for (int point = 0; point < rest.length / 3; point++) {
            double x = 0;
            double y = 0;
            double z = 0;
            for (int k = count * point; k < count * (point + 1); k++) {
                int c = 3 * carriers[k];
                x += weights[k] * (carrier[c] - carrierRest[c]);
                y += weights[k] * (carrier[c + 1] - carrierRest[c + 1]);
                z += weights[k] * (carrier[c + 2] - carrierRest[c + 2]);
            }
            position[3 * point] = rest[3 * point] + x;
            position[3 * point + 1] = rest[3 * point + 1] + y;
            position[3 * point + 2] = rest[3 * point + 2] + z;
        }
        return position;
    }
}
