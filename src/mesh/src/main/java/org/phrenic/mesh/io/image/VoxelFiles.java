package org.phrenic.mesh.io.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.zip.Deflater;
import java.util.zip.GZIPOutputStream;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * Writes volumes of real values, labels and displacements. The extension gives the format:
 *
 * <ul>
 *   <li>{@code nii.gz}, {@code nii}: NIfTI-1; displacements have intent 1006, dimensions x, y, z, 1, 3 and RAS vectors;
 *       several frames are a fourth dimension;
 *   <li>{@code nrrd}: gzip, LPS; displacements are of kind vector; one frame;
 *   <li>{@code mha}: MetaImage, uncompressed, LPS; three channels for displacements; one frame.
 * </ul>
 */
public final class VoxelFiles {
    /** Extensions that can be written. */
    public static final List<String> WRITABLE = List.of("nii.gz", "nii", "nrrd", "mha");

    private VoxelFiles() {}

    /**
     * Writes a file, completely or not at all.
     *
     * @throws BadInputException if the extension is none of {@link #WRITABLE}, or has no room for several frames
     * @throws org.phrenic.file.OutputException if the file cannot be written
     */
    public static void write(Path file, VoxelSeries series) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        String ending = WRITABLE.stream()
                .filter(known -> name.endsWith("." + known))
                .findFirst()
                .orElseThrow(() -> new BadInputException(
                        file + ": found another ending, expected one of " + String.join(", ", WRITABLE)));
        boolean nifti = ending.startsWith("nii");
        if (series.frames() > 1 && !nifti) {
            throw new BadInputException(file + ": found " + series.frames() + " frames, expected nii or nii.gz");
        }
        AtomicFile.write(file, out -> {
            if (nifti) {
                boolean packed = ending.equals("nii.gz");
                try (OutputStream to = packed ? new Fast(out) : out) {
                    nifti(series, to);
                }
            } else {
                byte[] header = (ending.equals("nrrd") ? NrrdHeader.text(series) : MetaImageHeader.text(series))
                        .getBytes(StandardCharsets.UTF_8);
                out.write(header);
                try (OutputStream to = ending.equals("nrrd") ? new Fast(out) : out) {
                    interleaved(series, to);
                }
            }
        });
    }

    /** Packs with little effort: voxels of images hardly get smaller with more. */
    private static final class Fast extends GZIPOutputStream {
        Fast(OutputStream out) throws IOException {
            super(out, 1 << 16);
            def.setLevel(Deflater.BEST_SPEED);
        }
    }

    private static void nifti(VoxelSeries series, OutputStream out) throws IOException {
        VoxelBox box = series.box();
        NiftiVolumeHeader header = new NiftiVolumeHeader(box, series.type())
                .described(series.about().getOrDefault(VoxelSeries.CONTENT, ""));
        if (series.components() == 3) {
            header.displacement(box);
        } else if (series.frames() > 1 || series.times().firstS() > 0) {
            header.frames(box, series.times());
        }
        out.write(header.bytes());
        int slice = box.columns() * box.rows();
        for (int frame = 0; frame < series.frames(); frame++) {
            float[] values = series.frame().apply(frame);
            for (int component = 0; component < series.components(); component++) {
                double sign = series.components() == 3 && component < 2 ? -1 : 1;
                for (int k = 0; k < box.slices(); k++) {
                    out.write(series.encode(values, component, k * slice, (k + 1) * slice, sign));
                }
            }
        }
    }

    private static void interleaved(VoxelSeries series, OutputStream out) throws IOException {
        int slice = series.box().columns() * series.box().rows();
        float[] values = series.frame().apply(0);
        for (int k = 0; k < series.box().slices(); k++) {
            out.write(series.encode(values, k * slice, (k + 1) * slice));
        }
    }
}
