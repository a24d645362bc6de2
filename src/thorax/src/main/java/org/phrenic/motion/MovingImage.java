package org.phrenic.motion;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.image.VoxelSeries;
import org.phrenic.mesh.io.raster.MissingSpacing;
import org.phrenic.mesh.io.volume.ImageVolume;
import org.phrenic.mesh.io.volume.ImageVolumeFiles;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * An image of a body at rest that moves with it. Labels are carried to the nearest voxel; values linearly, and whole
 * numbers of 16 bits, such as Hounsfield units, are rounded to such. What comes from beyond the image is its least
 * value, or label 0.
 */
final class MovingImage {
    private final boolean labels;
    private final float[] values;
    private final float beyond;
    private final ScalarType type;
    private final List<String> notes;
    private final MotionSampler sampler;

    /** @throws BadInputException if the file cannot be used or does not overlap the body */
    MovingImage(Path file, boolean labels, BodyMotion motion) {
        this.labels = labels;
        VoxelBox box;
        if (labels) {
            LabelVolume volume = LabelVolumeFiles.read(file);
            box = VoxelBox.of(volume.grid());
            values = MotionSampler.values(volume.grid());
            type = volume.grid().counts().length <= LabelGrid.MAX_BYTE_LABEL + 1 ? ScalarType.UINT8 : ScalarType.UINT16;
            notes = volume.notes();
            beyond = 0;
        } else {
            ImageVolume volume = ImageVolumeFiles.read(file);
            box = VoxelBox.of(volume.grid());
            values = volume.grid().values();
            float least = Float.POSITIVE_INFINITY;
            boolean whole = true;
            for (float value : values) {
                least = Math.min(least, value);
                whole &= value == (short) value;
            }
            type = whole ? ScalarType.INT16 : ScalarType.FLOAT32;
            notes = volume.notes();
            beyond = least;
        }
        if (MissingSpacing.isIn(notes)) {
            throw new BadInputException(
                    "--warp " + file + ": found no spacing of its voxels, expected it in the file, in mm");
        }
        sampler = new MotionSampler(motion, box);
        if (sampler.voxelsInBody() == 0) {
            throw new BadInputException("--warp " + file
                    + ": found no voxel inside the body, expected an image of this body in its axes (LPS, mm)");
        }
    }

    List<String> notes() {
        return notes;
    }

    MotionSampler sampler() {
        return sampler;
    }

    /** Bytes of a voxel in a file that is not packed. */
    int bytesAVoxel() {
        return type.size();
    }

    /** The image as it is now. */
    float[] warped() {
        return labels ? sampler.warpNearest(values) : sampler.warpLinear(values, beyond);
    }

    /** The image as it is now, as a file of its own. */
    VoxelSeries frame() {
        return VoxelSeries.of(sampler.box(), 1, type, warped(), about());
    }

    private Map<String, String> about() {
        return Map.of(VoxelSeries.CONTENT, (labels ? "labels" : "image") + " carried by the motion of the body");
    }

    /** The image at several times. */
    VoxelSeries series(double[] times, IntFunction<float[]> frame) {
        return new VoxelSeries(sampler.box(), 1, type, VoxelSeries.Times.of(times), frame, about());
    }
}
