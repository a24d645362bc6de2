package org.phrenic.patient.segmentation;

import java.util.stream.IntStream;
import org.phrenic.patient.label.LabelTable;

/**
 * Aids of a plan of radiotherapy, such as rings and doses, whose voxels are of the body about them. Each is given to
 * the segment, or to the background, that it meets beyond the aids in the most of the six directions of the grid, of
 * equal ones to the nearest. A direction that leads to an end of the volume tells nothing.
 */
public final class PlanAids {
    private static final int UNTOLD = -1;

    private final Segmentation s;
    /** Whether each segment is an aid. */
    private final boolean[] aid;

    private PlanAids(Segmentation s) {
        this.s = s;
        aid = new boolean[s.names().size() + 1];
        for (int segment = 1; segment < aid.length; segment++) {
            aid[segment] = LabelTable.isOfPlan(s.names().get(segment - 1));
        }
    }

    /** Gives the voxels of all aids to what lies about them. */
    public static void giveToTheirSurroundings(Segmentation s) {
        PlanAids aids = new PlanAids(s);
        if (IntStream.range(1, aids.aid.length).noneMatch(segment -> aids.aid[segment])) {
            return;
        }
        byte[] given = s.voxels.clone();
        int layer = s.columns * s.rows;
        IntStream.range(0, s.slices).parallel().forEach(slice -> {
            for (int v = slice * layer; v < (slice + 1) * layer; v++) {
                if (aids.aid[s.segmentAt(v)]) {
                    given[v] = (byte) aids.segmentAbout(v);
                }
            }
        });
        s.voxels = given;
    }

    private int segmentAbout(int voxel) {
        int[] steps = s.steps();
        int[] met = new int[steps.length];
        int[] distance = new int[steps.length];
        for (int step = 0; step < steps.length; step++) {
            int v = voxel;
            while (aid[s.segmentAt(v)] && !s.isAtBorder(v, step)) {
                v += steps[step];
                distance[step]++;
            }
            boolean atBorder = aid[s.segmentAt(v)];
            met[step] = !atBorder ? s.segmentAt(v) : isAtEnd(v, step) ? UNTOLD : 0;
        }
        return most(met, distance);
    }

    /** Whether the volume ends at a voxel in the direction of the nth of the steps. */
    private boolean isAtEnd(int voxel, int step) {
        int end = (step % 2 == 0 ? 1 : 8) << (step / 2);
        return (s.ends(voxel) & end) != 0;
    }

    private static int most(int[] met, int[] distance) {
        int best = 0;
        int most = 0;
        int nearest = 0;
        for (int of : met) {
            int times = 0;
            int least = Integer.MAX_VALUE;
            for (int step = 0; step < met.length && of != UNTOLD; step++) {
                times += met[step] == of ? 1 : 0;
                least = met[step] == of ? Math.min(least, distance[step]) : least;
            }
            if (times > most || (times == most && least < nearest)) {
                best = of;
                most = times;
                nearest = least;
            }
        }
        return best;
    }
}
