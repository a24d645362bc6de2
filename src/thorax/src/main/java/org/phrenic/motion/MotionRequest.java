package org.phrenic.motion;

import java.nio.file.Path;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.image.VoxelFiles;

/**
 * What to write of a motion.
 *
 * @param gridMm edge of the voxels of displacement fields, mm; 0 for the voxels of the image, or none without one
 * @param points file of points to carry; null for none
 * @param image image of the body at rest that breathes with it; null for none
 * @param labels whether the image holds labels
 * @param jacobian whether Jacobian and ventilation are written
 * @param regions whether the region of each voxel is written
 * @param format extension of the fields, one of {@link VoxelFiles#WRITABLE}
 */
public record MotionRequest(
        double gridMm, Path points, Path image, boolean labels, boolean jacobian, boolean regions, String format) {
    /** @throws BadInputException if nothing is asked for, or the format is unknown */
    public MotionRequest {
        if (gridMm == 0 && points == null && image == null) {
            throw new BadInputException("motion: found none of --grid, --points and --warp, expected one of them");
        }
        if (labels && image == null) {
            throw new BadInputException("--labels: found no --warp, expected an image of labels");
        }
        if (jacobian && gridMm == 0 && image == null) {
            throw new BadInputException("--jacobian: found neither --grid nor --warp, expected voxels");
        }
        if (regions && gridMm == 0) {
            throw new BadInputException("--regions: found no --grid, expected the edge of its voxels");
        }
        if (!VoxelFiles.WRITABLE.contains(format)) {
            throw new BadInputException(
                    "--format: found '" + format + "', expected one of " + String.join(", ", VoxelFiles.WRITABLE));
        }
    }
}
