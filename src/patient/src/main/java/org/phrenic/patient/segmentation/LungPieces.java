package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
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
}
