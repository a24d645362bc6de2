package org.phrenic.patient.segmentation;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Voxels of a structure in small parts away from its large ones, the most frequent error of segmentations. Boxes,
 * variances and the ends of a scan that a structure reaches are taken without them. A rib, a vertebra or a disc that is
 * small beside the usual one is nothing but specks, unless it reaches an end of the scan, which may cut off the rest.
 */
public final class Specks {
    /** Greatest size of a speck over the largest part of a bone. */
    private static final double SHARE_OF_BONE = 0.05;
    /** The same of a lung: an apex that lies apart has more. */
    private static final double SHARE_OF_LUNG = 0.01;
    /** Least size of a rib over that of the median one; the shortest ribs 12 have 0.03. */
    public static final double SHARE_OF_RIB = 0.02;
    /** Least size of a vertebra or a disc over that of the median one of both. */
    private static final double SHARE_OF_VERTEBRA = 0.05;

    /**
     * Segments that are alike in size.
     *
     * @param least size of one that is no speck over that of the median one
     */
    private record Alike(int[] segments, double least) {
        static Alike of(Segmentation s, Predicate<String> names, double least) {
            return new Alike(s.names().stream().filter(names).mapToInt(s::find).toArray(), least);
        }
    }

    private final BitSet voxels = new BitSet();

    private Specks() {}

    public static Specks none() {
        return new Specks();
    }

    /** The specks of the ribs, the vertebrae and the discs of a volume. */
    public static Specks ofBones(Segmentation s) {
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        Alike ribs = Alike.of(s, Specks::isRib, SHARE_OF_RIB);
        Alike spine = Alike.of(s, Specks::isOfSpine, SHARE_OF_VERTEBRA);
        for (Alike alike : List.of(ribs, spine)) {
            Arrays.stream(alike.segments).forEach(segment -> groups[segment] = (byte) segment);
        }
        return of(s, groups, SHARE_OF_BONE, ribs, spine);
    }

    private static boolean isRib(String name) {
        return SegmentationRepair.kind(name).equals(Optional.of(StructureKind.RIB));
    }

    private static boolean isOfSpine(String name) {
        return name.startsWith("vertebra_") || name.startsWith("disc_");
    }

    static Specks ofLung(Segmentation s, int segment) {
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        groups[segment] = (byte) segment;
        return of(s, groups, SHARE_OF_LUNG);
    }

    private static Specks of(Segmentation s, byte[] groups, double share, Alike... kinds) {
        VoxelRuns runs = new VoxelRuns(s, groups, true);
        int[] largest = new int[groups.length];
        boolean[] isCut = new boolean[groups.length];
        for (int run = 0; run < runs.count(); run++) {
            int segment = s.segmentAt(runs.from(run));
            largest[segment] = Math.max(largest[segment], runs.size(runs.component(run)));
            isCut[segment] |= s.ends(runs.from(run)) != 0 || s.ends(runs.to(run) - 1) != 0;
        }
        double[] least =
                Arrays.stream(largest).mapToDouble(size -> share * size).toArray();
        int[] counts = s.counts();
        for (Alike kind : kinds) {
            int[] sizes = Arrays.stream(kind.segments)
                    .map(segment -> counts[segment])
                    .filter(size -> size > 0)
                    .sorted()
                    .toArray();
            Arrays.stream(kind.segments)
                    .filter(segment -> counts[segment] > 0 && !isCut[segment])
                    .filter(segment -> counts[segment] < kind.least * sizes[sizes.length / 2])
                    .forEach(segment -> least[segment] = Double.POSITIVE_INFINITY);
        }
        Specks specks = new Specks();
        for (int run = 0; run < runs.count(); run++) {
            if (runs.size(runs.component(run)) < least[s.segmentAt(runs.from(run))]) {
                specks.voxels.set(runs.from(run), runs.to(run));
            }
        }
        return specks;
    }

    public boolean contain(int voxel) {
        return voxels.get(voxel);
    }
}
