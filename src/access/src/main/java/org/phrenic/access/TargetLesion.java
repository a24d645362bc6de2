package org.phrenic.access;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/**
 * A spherical lesion in the liver.
 *
 * @param restMm centre at end-expiration, LPS, mm; read-only
 */
public record TargetLesion(double[] restMm, double diameterMm) {
    /** Allowed range of diameters, mm. */
    public static final double SMALLEST_MM = 5;

    public static final double LARGEST_MM = 80;

    /**
     * Mean, standard deviation and bounds of random diameters, mm. Biopsied lesions measure 23 +/- 14 mm (PMC4927599).
     */
    private static final double MEAN_MM = 23;

    private static final double SD_MM = 14;
    private static final double SMALLEST_RANDOM_MM = 8;
    private static final double LARGEST_RANDOM_MM = 50;

    /** Diameters that are tried where a liver has no room for a greater one, mm. */
    private static final double[] SMALLER_MM = {15, 10, 8, SMALLEST_MM};

    private static final double RAY_MM = 400;
    private static final int MAX_DRAWS = 100_000;

    /**
     * Creates a target at a position.
     *
     * @throws BadInputException if the position is not in the liver or the diameter is out of range
     */
    public static TargetLesion at(MovingAnatomy scene, double[] restMm, double diameterMm) {
        if (!(diameterMm >= SMALLEST_MM && diameterMm <= LARGEST_MM)) {
            throw new BadInputException("target: found a diameter of " + diameterMm + " mm, expected " + SMALLEST_MM
                    + " to " + LARGEST_MM + " mm");
        }
        TriangleMesh liver = scene.liver().surface().rest();
        TriangleTree tree = new TriangleTree(liver);
        if (!tree.isInside(restMm[0], restMm[1], restMm[2])) {
            TriangleTree.Hit hit = new TriangleTree.Hit();
            tree.closest(restMm[0], restMm[1], restMm[2], hit);
            double outside = Math.sqrt(hit.distanceSquared);
            throw new BadInputException(Numbers.format(
                    "target: found (%.1f, %.1f, %.1f), %.1f mm outside of the liver, expected a place within it",
                    restMm[0], restMm[1], restMm[2], outside));
        }
        return new TargetLesion(restMm.clone(), diameterMm);
    }

    /**
     * Creates a target below a point of the liver surface.
     *
     * @param onLiverRest surface point at end-expiration
     * @param direction unit vector of the line of sight
     * @param depthMm depth below the surface; half the thickness where the liver is thinner than twice this depth
     * @throws BadInputException as in {@link #at}
     */
    public static TargetLesion behindSurface(
            MovingAnatomy scene, double[] onLiverRest, double[] direction, double depthMm, double diameterMm) {
        SegmentProbe probe = new SegmentProbe();
        double[] far = Vectors.addScaled(onLiverRest, direction, RAY_MM);
        double[] near = Vectors.addScaled(onLiverRest, direction, -1);
        probe.set(near[0], near[1], near[2], far[0], far[1], far[2]);
        int count = probe.intersect(new TriangleTree(scene.liver().surface().rest()));
        double through = 2 * depthMm;
        for (int i = count - 1; i >= 0; i--) {
            if (probe.facing(i) < 0 && probe.depth(i) > 2) {
                through = probe.depth(i) - 1;
            }
        }
        return at(scene, Vectors.addScaled(onLiverRest, direction, Math.min(depthMm, 0.5 * through)), diameterMm);
    }

    /**
     * Creates a random target that lies completely inside the liver.
     *
     * @param diameterMm NaN for a random diameter
     */
    public static TargetLesion random(MovingAnatomy scene, long seed, double diameterMm) {
        Random random = SeededRandom.of(seed);
        double diameter = diameterMm;
        while (Double.isNaN(diameter)) {
            double drawn = MEAN_MM + SD_MM * random.nextGaussian();
            diameter = drawn >= SMALLEST_RANDOM_MM && drawn <= LARGEST_RANDOM_MM ? drawn : Double.NaN;
        }
        double size = diameter;
        return drawn(scene, random, size).orElseThrow(() -> noRoom(size));
    }

    /**
     * Creates a random target that lies completely inside the liver, as large as asked for or, where that has no room,
     * as one of the usual smaller diameters.
     *
     * @throws BadInputException if the liver has no room for the smallest
     */
    public static TargetLesion randomUpTo(MovingAnatomy scene, long seed, double greatestMm) {
        return DoubleStream.concat(
                        DoubleStream.of(greatestMm), Arrays.stream(SMALLER_MM).filter(mm -> mm < greatestMm))
                .mapToObj(mm -> drawn(scene, SeededRandom.of(seed), mm))
                .flatMap(Optional::stream)
                .findFirst()
                .orElseThrow(() -> noRoom(SMALLEST_MM));
    }

    private static Optional<TargetLesion> drawn(MovingAnatomy scene, Random random, double diameter) {
        TriangleTree tree = new TriangleTree(scene.liver().surface().rest());
        double[] box = scene.liver().surface().rest().bounds();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int i = 0; i < MAX_DRAWS; i++) {
            double[] p = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                p[axis] = box[axis] + random.nextDouble() * (box[3 + axis] - box[axis]);
            }
            tree.closest(p[0], p[1], p[2], hit);
            if (hit.distanceSquared > 0.25 * diameter * diameter && tree.isInside(p[0], p[1], p[2])) {
                return Optional.of(at(scene, p, diameter));
            }
        }
        return Optional.empty();
    }

    private static BadInputException noRoom(double diameter) {
        return new BadInputException("target: found no room for a sphere of " + diameter
                + " mm within the liver, expected a " + (diameter > SMALLEST_MM ? "smaller diameter" : "larger liver"));
    }

    /** Radius, mm. */
    public double radiusMm() {
        return 0.5 * diameterMm;
    }
}
