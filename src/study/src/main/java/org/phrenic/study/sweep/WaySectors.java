package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.access.path.AccessMap;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;

/**
 * Directions of straight ways to a target, seen from it, in sectors of 20 by 20 degrees. The azimuth is 0 from the
 * front and 90 from the right of the body; the elevation is positive from above. Ways to the liver from the right and
 * the front.
 */
public final class WaySectors {
    private static final int WIDTH_DEG = 20;
    private static final int FIRST_AZIMUTH_DEG = -30;
    private static final int AZIMUTHS = 9;
    private static final int FIRST_ELEVATION_DEG = -50;
    private static final int ELEVATIONS = 5;

    private WaySectors() {}

    /** Middles of the sectors from left to right of a map, degrees. */
    public static int[] azimuthsDeg() {
        int[] all = new int[AZIMUTHS];
        Arrays.setAll(all, i -> FIRST_AZIMUTH_DEG + WIDTH_DEG * i);
        return all;
    }

    /** Middles of the sectors from below, degrees. */
    public static int[] elevationsDeg() {
        int[] all = new int[ELEVATIONS];
        Arrays.setAll(all, i -> FIRST_ELEVATION_DEG + WIDTH_DEG * i);
        return all;
    }

    /** Column of a sector, such as {@code free_a090_e-10}. */
    public static String column(int azimuthDeg, int elevationDeg) {
        return Numbers.format("free_a%03d_e%+03d", azimuthDeg, elevationDeg);
    }

    /** All columns, azimuth after azimuth, each from below. */
    static List<String> columns() {
        List<String> columns = new ArrayList<>();
        for (int azimuth : azimuthsDeg()) {
            for (int elevation : elevationsDeg()) {
                columns.add(column(azimuth, elevation));
            }
        }
        return columns;
    }

    /** For each column 1 if a way is free during the whole breath, 0 if none is, NaN without a point in reach. */
    static double[] free(AccessMap map) {
        double[] free = new double[AZIMUTHS * ELEVATIONS];
        Arrays.fill(free, Double.NaN);
        for (int v = 0; v < map.size(); v++) {
            int sector = map.isInReach(0, v) ? sector(Vectors.subtract(map.pointAtRest(v), map.target(0))) : -1;
            if (sector >= 0) {
                boolean open = map.access(v) == AccessMap.Access.FREE;
                free[sector] = open || free[sector] == 1 ? 1 : 0;
            }
        }
        return free;
    }

    /** Number of the sector of a direction, LPS; -1 outside of all. */
    static int sector(double[] direction) {
        double azimuth = Math.toDegrees(StrictMath.atan2(-direction[0], -direction[1]));
        double level = Math.sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        double elevation = Math.toDegrees(StrictMath.atan2(direction[2], level));
        int a = (int) Math.floor((azimuth - FIRST_AZIMUTH_DEG) / WIDTH_DEG + 0.5);
        int e = (int) Math.floor((elevation - FIRST_ELEVATION_DEG) / WIDTH_DEG + 0.5);
        return a < 0 || a >= AZIMUTHS || e < 0 || e >= ELEVATIONS ? -1 : a * ELEVATIONS + e;
    }
}
