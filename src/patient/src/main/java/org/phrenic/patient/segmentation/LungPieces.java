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
        Optional<Pieces> right = Pieces.of(s, "lung_R");
        right.ifPresent(pieces -> giveToOther(s, pieces, "lung_L", notes));
        Optional<Pieces> left = Pieces.of(s, "lung_L");
        left.ifPresent(pieces -> giveToOther(s, pieces, "lung_R", notes));
        if (!notes.isEmpty()) {
            right = Pieces.of(s, "lung_R");
            left = Pieces.of(s, "lung_L");
        }
        right.ifPresent(pieces -> name(s, pieces, notes));
        left.ifPresent(pieces -> name(s, pieces, notes));
        return notes;
    }

    /**
     * The connected pieces of a lung.
     *
     * @param marks number of the piece of each cell of the region, from {@value #FIRST} on
     * @param sizes number of voxels by number
     */
    private record Pieces(String lung, VoxelRegion region, byte[] marks, int[] sizes) {
        static final int FIRST = 2;

        static Optional<Pieces> of(Segmentation s, String lung) {
            if (s.find(lung) == 0) {
                return Optional.empty();
            }
            VoxelRegion region = new VoxelRegion(s, s.find(lung));
            byte[] marks = new byte[region.cells()];
            return Optional.of(new Pieces(lung, region, marks, region.connectedComponents(0, marks)));
        }

        int largest() {
            return IntStream.range(0, sizes.length)
                    .reduce((a, b) -> sizes[b] > sizes[a] ? b : a)
                    .orElse(0);
        }

        int[] voxels(int wanted) {
            return IntStream.range(0, marks.length)
                    .filter(cell -> marks[cell] == wanted)
                    .map(region::voxel)
                    .toArray();
        }
    }

    private static void giveToOther(Segmentation s, Pieces pieces, String other, List<String> notes) {
        if (pieces.sizes.length < Pieces.FIRST + 2) {
            return;
        }
        Optional<LungVoxels> beyond = LungVoxels.of(s, other);
        if (beyond.isEmpty()) {
            return;
        }
        int largest = pieces.largest();
        double middle = 0.5 * (beyond.get().centre()[0] + meanAcross(s, pieces.voxels(largest)));
        boolean otherIsLeft = beyond.get().centre()[0] > middle;
        for (int wanted = Pieces.FIRST; wanted < pieces.sizes.length; wanted++) {
            if (wanted != largest && isOf(s, other, pieces.voxels(wanted), middle, otherIsLeft)) {
                pieces.region.assign(pieces.marks, wanted, s.find(other));
                notes.add(String.format(
                        Locale.ROOT,
                        "%s: a piece of %.0f ml lies at the other lung; it is taken for a part of %s",
                        pieces.lung,
                        s.grid().volumeMl(pieces.sizes[wanted]),
                        other));
            }
        }
    }

    private static double meanAcross(Segmentation s, int[] voxels) {
        return Arrays.stream(voxels)
                .mapToDouble(v -> s.coordinate(v, 0))
                .average()
                .orElse(0);
    }

    /** Whether a piece lies on the other lung's side of a sagittal plane and has many faces in common with it. */
    private static boolean isOf(Segmentation s, String other, int[] piece, double middle, boolean otherIsLeft) {
        int own = s.segmentAt(piece[0]);
        int wanted = s.find(other);
        int[] steps = s.steps();
        int across = 0;
        int faces = 0;
        int shared = 0;
        for (int voxel : piece) {
            across += s.coordinate(voxel, 0) > middle == otherIsLeft ? 1 : 0;
            for (int step : steps) {
                int next = voxel + step;
                int beside = next < 0 || next >= s.voxels.length ? 0 : s.segmentAt(next);
                faces += beside == own ? 0 : 1;
                shared += beside == wanted ? 1 : 0;
            }
        }
        return across > BEYOND * piece.length && shared > TOUCHING * faces;
    }

    private static void name(Segmentation s, Pieces pieces, List<String> notes) {
        String lung = pieces.lung;
        int[] sizes = pieces.sizes;
        int total = Arrays.stream(sizes).sum();
        List<Integer> large = IntStream.range(0, sizes.length)
                .filter(p -> sizes[p] > LEAST_SHARE * total)
                .boxed()
                .sorted(Comparator.comparingInt(p -> -sizes[p]))
                .toList();
        for (int rank = 1; rank < large.size(); rank++) {
            int wanted = large.get(rank);
            String name = lung + "_" + (rank + 1);
            pieces.region.assign(pieces.marks, wanted, s.segment(name));
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
     * Where the voxels of a lung lie, without specks.
     *
     * @param centre their mean, mm
     * @param lowest least height of one, mm
     * @param highest greatest height of one, mm
     * @param isCutAbove whether the lung reaches the upper end of the volume
     */
    public record LungVoxels(double[] centre, double lowest, double highest, boolean isCutAbove) {
        /** @return empty if no voxel has the name */
        public static Optional<LungVoxels> of(Segmentation s, String name) {
            int segment = s.find(name);
            Specks specks = segment > 0 ? Specks.ofLung(s, segment) : Specks.none();
            double[] centre = new double[3];
            double lowest = Double.POSITIVE_INFINITY;
            double highest = Double.NEGATIVE_INFINITY;
            int ends = 0;
            int count = 0;
            for (int v = 0; segment > 0 && v < s.voxels.length; v++) {
                if (s.segmentAt(v) == segment && !specks.contain(v)) {
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
