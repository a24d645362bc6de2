package org.phrenic.access.imaging;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Lungs and liver as what encloses vessels, airways and lesions. Surfaces of organs may run around what lies in them,
 * as those of scans do, and then such a structure replaces the organ and not the soft tissue around it.
 */
final class EnclosingOrgans {
    /** Number of vertices of a structure that are looked at, at most. */
    private static final int SAMPLES = 500;
    /** Beyond every body, mm. */
    private static final double FAR_MM = 1e4;

    private final List<TriangleTree> organs = new ArrayList<>();
    private final SegmentProbe probe = new SegmentProbe();

    /** @param organs closed surfaces */
    EnclosingOrgans(List<TriangleMesh> organs) {
        organs.forEach(organ -> this.organs.add(new TriangleTree(organ)));
    }

    /**
     * The shares of a structure that lie in each organ, measured by its vertices, made to add up to 1. All are 0 unless
     * the organs have at least half of it between them.
     */
    double[] sharesOf(TriangleMesh structure) {
        double[] inside = new double[organs.size()];
        int step = Math.max(1, (structure.vertexCount() + SAMPLES - 1) / SAMPLES);
        int samples = 0;
        double enclosed = 0;
        for (int v = 0; v < structure.vertexCount(); v += step, samples++) {
            double x = structure.x(v);
            double y = structure.y(v);
            double z = structure.z(v);
            probe.set(x, y, z, x + FAR_MM, y, z);
            for (int i = 0; i < inside.length; i++) {
                if (leaves(organs.get(i))) {
                    inside[i]++;
                    enclosed++;
                    break;
                }
            }
        }
        double scale = 2 * enclosed >= samples ? 1 / enclosed : 0;
        return Arrays.stream(inside).map(n -> scale * n).toArray();
    }

    /** Whether the probe leaves a closed surface more often than it enters it, or the other way round: inside out. */
    private boolean leaves(TriangleTree organ) {
        int balance = 0;
        for (int i = probe.intersect(organ) - 1; i >= 0; i--) {
            balance += probe.facing(i);
        }
        return balance != 0;
    }
}
