package org.phrenic.anatomy.cage;

import java.util.Arrays;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;

/**
 * The course of a rib: its middle line from the posterior to the anterior end, found from its surface. Each vertex has
 * a station, the mean of its distances along edges from both ends; the line runs through the means of vertices of equal
 * station. Seams, holes and separate patches do not matter ({@link RibEnds}).
 */
public final class RibCourse {
    /** Length of the rib that one point of the line averages, mm; a rib is about as thick. */
    private static final double BIN_MM = 6;

    private static final int SMOOTHINGS = 2;

    private final double[] points;
    private final Polyline line;
    private final double[] stations;

    private RibCourse(double[] points, double[] stations) {
        this.points = points;
        this.stations = stations;
        line = Polyline.of(points);
    }

    /**
     * Finds the course of a rib.
     *
     * @param rib surface in LPS, mm
     * @param side right or left
     * @throws IllegalArgumentException if the mesh has no extent or the side is the midline
     */
    public static RibCourse of(TriangleMesh rib, Side side) {
        RibEnds.Stations found = RibEnds.stations(rib, side);
        double[] along = found.along();
        int bins = Math.max(3, (int) Math.round(found.lengthMm() / BIN_MM));
        double[] sum = new double[3 * bins];
        int[] count = new int[bins];
        for (int v = 0; v < along.length; v++) {
            int bin = Math.max(0, Math.min(bins - 1, (int) (along[v] / found.lengthMm() * bins)));
            count[bin]++;
            for (int k = 0; k < 3; k++) {
                sum[3 * bin + k] += rib.positions()[3 * v + k];
            }
        }
        double[] line = new double[3 * bins + 6];
        double[] head = found.ends().head();
        double[] anterior = found.ends().anterior();
        System.arraycopy(head, 0, line, 0, 3);
        int n = 1;
        for (int bin = 0; bin < bins; bin++) {
            // The first and last bins have their middle within the region of an end.
            boolean inside = bin > 0 && bin < bins - 1 && count[bin] > 0;
            for (int k = 0; k < 3 && inside; k++) {
                line[3 * n + k] = sum[3 * bin + k] / count[bin];
            }
            n += inside ? 1 : 0;
        }
        System.arraycopy(anterior, 0, line, 3 * n, 3);
        double[] whole = Arrays.copyOf(line, 3 * n + 3);
        for (int i = 0; i < SMOOTHINGS; i++) {
            whole = smoothed(whole);
        }
        double[] stations = new double[along.length];
        for (int v = 0; v < along.length; v++) {
            stations[v] = Math.max(0, Math.min(1, along[v] / found.lengthMm()));
        }
        return new RibCourse(whole, stations);
    }

    private static double[] smoothed(double[] line) {
        double[] out = line.clone();
        for (int i = 3; i < line.length - 3; i++) {
            out[i] = 0.25 * line[i - 3] + 0.5 * line[i] + 0.25 * line[i + 3];
        }
        return out;
    }

    /** Points of the middle line from the posterior to the anterior end; x, y, z in turn, mm. */
    public double[] line() {
        return points.clone();
    }

    /** Length of the middle line, mm. */
    public double lengthMm() {
        return line.length();
    }

    /** Station of each vertex as a fraction of the length, 0 at the posterior and 1 at the anterior end. */
    public double[] stations() {
        return stations.clone();
    }

    /** Point of the middle line at a path from the posterior end, mm; beyond an end the line goes on straight. */
    public double[] at(double pathMm) {
        return line.pointAt(pathMm);
    }
}
