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

    /** Share of a piece nearer to the other lung than to its own from side to side, if it is the other one's. */
    private static final double BEYOND = 0.9;
    /** Least share of its faces that it has in common with that lung. */
    private static final double TOUCHING = 0.1;

    private LungPieces() {}

    /**
     * Gives pieces of a lung that lie in the other side of the chest, at the other lung, to that one, and other pieces
     * beside the largest the names {@code lung_R_2} and so on. Returns notes.
     */
    public static List<String> name(Segmentation s) {
        List<String> notes = new ArrayList<>();
        giveToOther(s, "lung_R", "lung_L", notes);
        giveToOther(s, "lung_L", "lung_R", notes);
        for (String lung : List.of("lung_R", "lung_L")) {
            if (s.find(lung) > 0) {
                name(s, lung, notes);
            }
        }
        return notes;
    }

    private static void giveToOther(Segmentation s, String lung, String other, List<String> notes) {
        Optional<LungVoxels> beyond = LungVoxels.of(s, other);
        if (beyond.isEmpty() || s.find(lung) == 0) {
            return;
        }
        VoxelRegion region = new VoxelRegion(s, s.find(lung));
        byte[] piece = new byte[region.cells()];
        int[] sizes = region.connectedComponents(0, piece);
        int largest = IntStream.range(0, sizes.length)
                .reduce((a, b) -> sizes[b] > sizes[a] ? b : a)
                .orElse(0);
        double middle = 0.5 * (beyond.get().centre()[0] + meanAcross(s, region, piece, largest));
        boolean otherIsLeft = beyond.get().centre()[0] > middle;
        for (int wanted = 2; wanted < sizes.length; wanted++) {
            if (wanted != largest && isOf(s, other, voxels(region, piece, wanted), middle, otherIsLeft)) {
                region.assign(piece, wanted, s.find(other));
                notes.add(String.format(
                        Locale.ROOT,
                        "%s: a piece of %.0f ml lies at the other lung; it is taken for a part of %s",
                        lung,
                        s.grid().volumeMl(sizes[wanted]),
                        other));
            }
        }
    }

    private static int[] voxels(VoxelRegion region, byte[] piece, int wanted) {
        return IntStream.range(0, piece.length)
                .filter(cell -> piece[cell] == wanted)
                .map(region::voxel)
                .toArray();
    }

    private static double meanAcross(Segmentation s, VoxelRegion region, byte[] piece, int wanted) {
        return Arrays.stream(voxels(region, piece, wanted))
                .mapToDouble(v -> s.coordinate(v, 0))
                .average()
                .orElse(0);
    }

    /** Whether a piece lies on the other lung's side of a sagittal plane and has many faces in common with it. */
    private static boolean isOf(Segmentation s, String other, int[] piece, double middle, boolean otherIsLeft) {
        int own = s.segmentAt(piece[0]);
        int across = 0;
        int faces = 0;
        int shared = 0;
        for (int voxel : piece) {
            across += s.coordinate(voxel, 0) > middle == otherIsLeft ? 1 : 0;
            for (int step : s.steps()) {
                int next = voxel + step;
                int beside = next < 0 || next >= s.voxels.length ? 0 : s.segmentAt(next);
                faces += beside == own ? 0 : 1;
                shared += beside == s.find(other) ? 1 : 0;
            }
        }
        return across > BEYOND * piece.length && shared > TOUCHING * faces;
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
