package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Names the pieces of a lung whose lobes lie apart, as with fluid in the fissure between them. Only one piece of a
 * structure becomes a surface; a lung can have several structures, such as lobes.
 */
public final class LungPieces {
    /**
     * Least size of a piece that is kept, over that of the lung. The smallest lobe, the right middle one, has 0.17;
     * smaller pieces are mostly gas in the bowel.
     */
    private static final double LEAST_SHARE = 0.1;

    private LungPieces() {}

    /** Gives pieces of a lung beside the largest the names {@code lung_R_2} and so on. Returns notes. */
    public static List<String> name(Segmentation s) {
        List<String> notes = new ArrayList<>();
        for (String lung : List.of("lung_R", "lung_L")) {
            if (s.find(lung) > 0) {
                name(s, lung, notes);
            }
        }
        return notes;
    }

    private static void name(Segmentation s, String lung, List<String> notes) {
        VoxelRegion region = new VoxelRegion(s, s.find(lung));
        byte[] piece = new byte[region.cells()];
        int[] sizes = region.connectedComponents(0, piece);
        int total = Arrays.stream(sizes).sum();
        List<Integer> large = IntStream.range(0, sizes.length)
                .filter(p -> sizes[p] > LEAST_SHARE * total)
                .boxed()
                .sorted(Comparator.comparingInt(p -> -sizes[p]))
                .toList();
        for (int rank = 1; rank < large.size(); rank++) {
            int wanted = large.get(rank);
            String name = lung + "_" + (rank + 1);
            region.assign(piece, wanted, s.segment(name));
            s.inheritFrom(name, lung);
            notes.add(String.format(
                    Locale.ROOT,
                    "%s: a piece of %.0f ml lies apart, as with fluid between lobes; it is kept as %s",
                    lung,
                    s.grid().volumeMl(sizes[wanted]),
                    name));
        }
    }

    /**
     * Where the voxels of a lung lie.
     *
     * @param centre their mean, mm
     * @param lowest least height of one, mm
     * @param highest greatest height of one, mm
     * @param isCutAbove whether the lung reaches the upper end of the volume
     */
    record LungVoxels(double[] centre, double lowest, double highest, boolean isCutAbove) {
        /** @return empty if no voxel has the name */
        static Optional<LungVoxels> of(Segmentation s, String name) {
            int segment = s.find(name);
            double[] centre = new double[3];
            double lowest = Double.POSITIVE_INFINITY;
            double highest = Double.NEGATIVE_INFINITY;
            int ends = 0;
            int count = 0;
            for (int v = 0; segment > 0 && v < s.voxels.length; v++) {
                if (s.segmentAt(v) == segment) {
                    count++;
                    for (int axis = 0; axis < 3; axis++) {
                        centre[axis] += (s.coordinate(v, axis) - centre[axis]) / count;
                    }
                    lowest = Math.min(lowest, s.coordinate(v, 2));
                    highest = Math.max(highest, s.coordinate(v, 2));
                    ends |= s.ends(v);
                }
            }
            boolean cut = (ends & s.endsToward(true)) != 0;
            return count == 0 ? Optional.empty() : Optional.of(new LungVoxels(centre, lowest, highest, cut));
        }
    }
}
