package org.phrenic.patient.segmentation;

import java.util.BitSet;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Voxels of a structure in small parts away from its large ones, the most frequent error of segmentations. Boxes,
 * variances and the ends of a scan that a structure reaches are taken without them.
 */
public final class Specks {
    /** Greatest size of a speck over the largest part of a bone. */
    private static final double SHARE_OF_BONE = 0.05;
    /** The same of a lung: an apex that lies apart has more. */
    private static final double SHARE_OF_LUNG = 0.01;

    private final BitSet voxels = new BitSet();

    private Specks() {}

    public static Specks none() {
        return new Specks();
    }

    /** The specks of the ribs and vertebrae of a volume. */
    public static Specks ofBones(Segmentation s) {
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        for (String name : s.names()) {
            Optional<StructureKind> kind = SegmentationRepair.kind(name);
            boolean bone = kind.filter(k -> k == StructureKind.RIB || k == StructureKind.VERTEBRA)
                    .isPresent();
            groups[s.find(name)] = (byte) (bone ? s.find(name) : 0);
        }
        return of(s, groups, SHARE_OF_BONE);
    }

    static Specks ofLung(Segmentation s, int segment) {
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        groups[segment] = (byte) segment;
        return of(s, groups, SHARE_OF_LUNG);
    }

    private static Specks of(Segmentation s, byte[] groups, double share) {
        VoxelRuns runs = new VoxelRuns(s, groups, true);
        int[] largest = new int[groups.length];
        for (int run = 0; run < runs.count(); run++) {
            int segment = s.segmentAt(runs.from(run));
            largest[segment] = Math.max(largest[segment], runs.size(runs.component(run)));
        }
        Specks specks = new Specks();
        for (int run = 0; run < runs.count(); run++) {
            if (runs.size(runs.component(run)) < share * largest[s.segmentAt(runs.from(run))]) {
                specks.voxels.set(runs.from(run), runs.to(run));
            }
        }
        return specks;
    }

    public boolean contain(int voxel) {
        return voxels.get(voxel);
    }
}
