package org.phrenic.patient.segmentation;

import java.util.Arrays;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.voxel.LabelGrid;

/** Heights of the thoracic vertebrae of a volume, by those and the lumbar ones. */
final class VertebraHeights {
    /** Level of the fifth lumbar vertebra. */
    private static final int LAST = StructureName.FIRST_LUMBAR + 4;

    private VertebraHeights() {}

    /**
     * Heights of vertebral bodies: means over the anterior halves of the vertebrae. Those that the scan does not show
     * are taken to follow at the usual distance.
     *
     * @return mm, by level; NaN if the volume shows none
     */
    static double[] of(Segmentation s) {
        double[] vertebraZ = new double[LAST + 1];
        Arrays.fill(vertebraZ, Double.NaN);
        double[][] sums = new double[LabelGrid.MAX_BYTE_LABEL + 1][3];
        int[] levels = new int[sums.length];
        for (String name : s.names()) {
            StructureName.parse(name)
                    .filter(n -> n.kind() == StructureKind.VERTEBRA && n.level() <= LAST)
                    .ifPresent(n -> levels[s.find(name)] = n.level());
        }
        for (int pass = 0; pass < 2; pass++) {
            for (int v = 0; v < s.voxels.length; v++) {
                int segment = s.segmentAt(v);
                if (levels[segment] > 0) {
                    double y = s.coordinate(v, 1);
                    double[] sum = sums[segment];
                    if (pass == 0) {
                        sum[0] += y;
                        sum[1]++;
                    } else if (y < sum[0]) {
                        sum[1]++;
                        sum[2] += s.coordinate(v, 2);
                    }
                }
            }
            for (int segment = 0; segment < sums.length; segment++) {
                if (sums[segment][1] > 0 && pass == 0) {
                    sums[segment][0] /= sums[segment][1];
                    sums[segment][1] = 0;
                } else if (sums[segment][1] > 0) {
                    vertebraZ[levels[segment]] = sums[segment][2] / sums[segment][1];
                }
            }
        }
        for (int level = LAST - 1; level > 0; level--) {
            vertebraZ[level] =
                    Double.isNaN(vertebraZ[level]) ? vertebraZ[level + 1] + RibNumbering.VERTEBRA_MM : vertebraZ[level];
        }
        for (int level = 2; level <= LAST; level++) {
            vertebraZ[level] =
                    Double.isNaN(vertebraZ[level]) ? vertebraZ[level - 1] - RibNumbering.VERTEBRA_MM : vertebraZ[level];
        }
        return vertebraZ;
    }
}
