package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

class VoxelBlocksTest {
    private final Segmentation s = new CageVoxels().withRibs(1).segmentation(CageVoxels.table(false));

    private IntList voxelsOf(String rib) {
        IntList voxels = new IntList();
        for (int v = 0; v < s.voxels().length; v++) {
            if (s.segmentAt(v) == s.find(rib)) {
                voxels.add(v);
            }
        }
        return voxels;
    }

    private double nearest(double[] p, IntList voxels) {
        return Arrays.stream(voxels.toArray())
                .mapToDouble(v -> {
                    double[] q = s.point(v);
                    double x = q[0] - p[0];
                    double y = q[1] - p[1];
                    double z = q[2] - p[2];
                    return Math.sqrt(x * x + y * y + z * z);
                })
                .min()
                .orElseThrow();
    }

    @Test
    void theNearestVoxelOfAPartIsFoundAlsoAmongThoseAddedToIt() {
        IntList rib = voxelsOf("rib_06_R");
        VoxelBlocks blocks = new VoxelBlocks(s, rib);
        Random random = new Random(1);
        for (int n = 0; n < 200; n++) {
            double[] p = s.point(random.nextInt(s.voxels().length));
            assertThat(blocks.distance(p)).isEqualTo(nearest(p, rib));
            rib.add(random.nextInt(s.voxels().length));
            blocks.extend();
        }
    }

    @Test
    void theNearestPartWithinADistanceIsTheFirstOfSeveral() {
        IntList fourth = voxelsOf("rib_04_R");
        IntList sixth = voxelsOf("rib_06_R");
        List<VoxelBlocks> parts =
                List.of(new VoxelBlocks(s, fourth), new VoxelBlocks(s, sixth), new VoxelBlocks(s, sixth));
        double[] p = s.point(sixth.get(0));
        assertThat(VoxelBlocks.nearest(parts, p, 25)).hasValue(1);
        p[0] -= 60;
        double distance = nearest(p, sixth);
        assertThat(VoxelBlocks.nearest(parts, p, Math.nextUp(distance))).isPresent();
        assertThat(VoxelBlocks.nearest(parts, p, distance)).isEmpty();
    }
}
