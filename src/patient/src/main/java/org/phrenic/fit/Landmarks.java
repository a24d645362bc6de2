package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.MovingLeastSquares;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.motion.SlidingElasticSolid;
import org.phrenic.simulation.observe.Surface;

/**
 * Pairs of points inside the lungs, at end-expiration and at the second breath level. They are not fitted to; they show
 * how right a fit is inside.
 *
 * @param from at end-expiration, in the axes of the body, as x, y, z triples, mm
 * @param scanned the same points at the second breath level, in the axes of its scan, mm
 * @param motion from the axes of that scan to those of the body
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Landmarks(double[] from, double[] scanned, RigidMotion motion) {
    /**
     * Errors of landmarks, mm.
     *
     * @param scanned distance between the two points of a pair as scanned
     * @param rigid the same after the rigid alignment of the scans: the error without a model
     * @param rigidLessMean the same after their mean displacement was subtracted as well
     * @param bySurface errors if each point follows the surface of its lung
     * @param fitted error if each point is carried by its lung, which slides ({@link SlidingElasticSolid})
     * @param fittedLessMean the same after the mean error vector was subtracted
     * @param shifts mean displacements
     */
    public record Errors(
            DistanceSummary scanned,
            DistanceSummary rigid,
            DistanceSummary rigidLessMean,
            BySurface bySurface,
            DistanceSummary fitted,
            DistanceSummary fittedLessMean,
            Shifts shifts) {}

    /**
     * Errors of points that follow the surface of a lung, mm.
     *
     * @param nearest error if each point is displaced as the nearest point of the lung's surface
     * @param attached error if each point follows the vertices of its lung's surface ({@link MovingLeastSquares})
     */
    public record BySurface(DistanceSummary nearest, DistanceSummary attached) {}

    /**
     * Mean displacements of the points, mm.
     *
     * @param byAlignment by the alignment
     * @param left what the alignment leaves
     * @param outside number of points outside the lungs of the body at end-expiration
     */
    public record Shifts(double[] byAlignment, double[] left, int outside) {}

    /**
     * Reads pairs from a CSV file with the columns x_mm, y_mm, z_mm, to_x_mm, to_y_mm, to_z_mm.
     *
     * @param alignment of the scan of the second breath level
     * @throws BadInputException if the file is invalid
     */
    public static Landmarks read(Path file, TargetAlignment alignment) {
        CsvTable table = CsvTable.read(file);
        if (table.rowCount() == 0) {
            throw new BadInputException(file + ": found no row, expected pairs of points");
        }
        return new Landmarks(
                FitTarget.points(table, FitTarget.FROM), FitTarget.points(table, FitTarget.TO), alignment.motion());
    }

    /** Errors in the current state of a body. */
    Errors errors(InspiratoryHold breath) {
        List<TriangleMesh> rest = new ArrayList<>();
        List<TriangleMesh> now = new ArrayList<>();
        List<Surface> all = breath.surfaces().surfaces();
        for (int i = 0; i < all.size(); i++) {
            if (all.get(i).kind() == StructureKind.LUNG) {
                rest.add(all.get(i).rest());
                now.add(breath.mesh(i));
            }
        }
        return errors(rest, now);
    }

    /**
     * Refuses a body whose lungs cannot carry points.
     *
     * @throws BadInputException if there is no lung, or one whose surface encloses no space
     */
    static void requireLungs(List<Surface> surfaces) {
        List<Surface> lungs =
                surfaces.stream().filter(s -> s.kind() == StructureKind.LUNG).toList();
        if (lungs.isEmpty()) {
            throw new BadInputException("--landmarks: found no lung in the body, expected one that carries them");
        }
        for (Surface lung : lungs) {
            if (!MeshMeasure.hasInside(lung.rest())) {
                throw new BadInputException("--landmarks: found an open surface for " + lung.name()
                        + ", expected lungs that enclose the points");
            }
        }
    }

    /** Errors for lungs at end-expiration and at the second breath level, in the same order. */
    Errors errors(List<TriangleMesh> rest, List<TriangleMesh> now) {
        double[] depths = new double[from.length / 3];
        int[] lungs = deepestIn(rest, depths);
        double[] carried = new double[from.length];
        double[] attached = new double[from.length];
        double[] beside = new double[from.length];
        for (int s = 0; s < rest.size(); s++) {
            TriangleTree tree = new TriangleTree(rest.get(s));
            SlidingElasticSolid solid = new SlidingElasticSolid(rest.get(s), now.get(s));
            for (int i = 0; i < lungs.length; i++) {
                if (lungs[i] == s) {
                    double[] place = Arrays.copyOfRange(from, 3 * i, 3 * i + 3);
                    double[] weights =
                            MovingLeastSquares.coefficients(rest.get(s).positions(), place);
                    double[] at =
                            MovingLeastSquares.position(weights, now.get(s).positions());
                    System.arraycopy(at, 0, attached, 3 * i, 3);
                    System.arraycopy(solid.moved(place), 0, carried, 3 * i, 3);
                    System.arraycopy(withNearest(tree, rest.get(s), now.get(s), place), 0, beside, 3 * i, 3);
                }
            }
        }
        double[] aligned = scanned.clone();
        motion.apply(aligned);
        int outside = (int) Arrays.stream(depths).filter(d -> d > 0).count();
        return new Errors(
                summary(scanned, from, false),
                summary(aligned, from, false),
                summary(aligned, from, true),
                new BySurface(summary(aligned, beside, false), summary(aligned, attached, false)),
                summary(aligned, carried, false),
                summary(aligned, carried, true),
                new Shifts(mean(aligned, scanned), mean(aligned, from), outside));
    }

    /** The lung that each point lies deepest in; writes its signed distance from it, mm. */
    private int[] deepestIn(List<TriangleMesh> rest, double[] depths) {
        int[] lungs = new int[depths.length];
        Arrays.fill(depths, Double.POSITIVE_INFINITY);
        for (int s = 0; s < rest.size(); s++) {
            double[] signed = new SurfaceDistance(rest.get(s)).sidedDistance(from);
            for (int i = 0; i < depths.length; i++) {
                if (signed[i] < depths[i]) {
                    depths[i] = signed[i];
                    lungs[i] = s;
                }
            }
        }
        return lungs;
    }

    /**
     * Writes the pairs in the axes of the body with the lung of each, as {@code phrenic motion --points} takes them.
     *
     * @param lungs at end-expiration
     */
    public void write(Path file, List<Structure> lungs) {
        int[] own = deepestIn(lungs.stream().map(Structure::mesh).toList(), new double[from.length / 3]);
        double[] aligned = scanned.clone();
        motion.apply(aligned);
        List<List<Object>> rows = new ArrayList<>();
        for (int i = 0; i < own.length; i++) {
            List<Object> row = new ArrayList<>(List.of(lungs.get(own[i]).name()));
            for (double[] places : List.of(from, aligned)) {
                for (int axis = 0; axis < 3; axis++) {
                    row.add(places[3 * i + axis]);
                }
            }
            rows.add(row);
        }
        List<String> header = new ArrayList<>(List.of("structure"));
        header.addAll(List.of(FitTarget.FROM));
        header.addAll(List.of(FitTarget.TO));
        CsvWriter.write(file, header, rows);
    }

    /** A point displaced as the nearest point of a surface. */
    private static double[] withNearest(TriangleTree tree, TriangleMesh rest, TriangleMesh now, double[] place) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(place[0], place[1], place[2], hit);
        double[] weights = {hit.weightA, hit.weightB, hit.weightC};
        double[] at = place.clone();
        for (int c = 0; c < 3; c++) {
            int v = 3 * rest.triangles()[3 * hit.triangle + c];
            for (int axis = 0; axis < 3; axis++) {
                at[axis] += weights[c] * (now.positions()[v + axis] - rest.positions()[v + axis]);
            }
        }
        return at;
    }

    private static DistanceSummary summary(double[] a, double[] b, boolean lessMean) {
        double[] shift = lessMean ? mean(a, b) : new double[3];
        double[] distances = new double[a.length / 3];
        for (int i = 0; i < distances.length; i++) {
            double squares = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = a[3 * i + axis] - b[3 * i + axis] - shift[axis];
                squares += d * d;
            }
            distances[i] = Math.sqrt(squares);
        }
        double[] weights = new double[distances.length];
        Arrays.fill(weights, 1);
        return DistanceSummary.of(distances, weights);
    }

    /** Mean of a - b. */
    private static double[] mean(double[] a, double[] b) {
        double[] mean = new double[3];
        for (int i = 0; i < a.length; i++) {
            mean[i % 3] += (a[i] - b[i]) * 3 / a.length;
        }
        return mean;
    }
}
