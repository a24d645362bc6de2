package org.phrenic.mesh.io.image;

import org.phrenic.mesh.voxel.VoxelBox;

/**
 * The header of an NRRD file, gzip, LPS. Displacements are of kind vector, the fastest axis. What is known of the
 * values follows as key and value pairs.
 */
final class NrrdHeader {
    private NrrdHeader() {}

    /** The header with the empty line that ends it. */
    static String text(VoxelSeries series) {
        VoxelBox box = series.box();
        boolean vectors = series.components() == 3;
        double[] m = box.toMm();
        StringBuilder text = new StringBuilder("NRRD0005\n");
        String type =
                switch (series.type()) {
                    case UINT8 -> "uint8";
                    case UINT16 -> "uint16";
                    case INT16 -> "int16";
                    default -> "float";
                };
        text.append("type: ").append(type).append('\n');
        text.append("dimension: ").append(vectors ? 4 : 3).append('\n');
        text.append("space: left-posterior-superior\n");
        text.append("sizes:")
                .append(vectors ? " 3" : "")
                .append(MetaImageHeader.joined(box.size()))
                .append('\n');
        text.append("space directions:").append(vectors ? " none" : "");
        for (int axis = 0; axis < 3; axis++) {
            text.append(" (" + m[axis] + "," + m[4 + axis] + "," + m[8 + axis] + ")");
        }
        text.append("\nkinds:").append(vectors ? " vector" : "").append(" domain domain domain\n");
        text.append("endian: little\nencoding: gzip\nspace units: \"mm\" \"mm\" \"mm\"\n");
        text.append("space origin: (" + m[3] + "," + m[7] + "," + m[11] + ")\n");
        series.about().forEach((key, value) -> {
            boolean field = key.equals(VoxelSeries.CONTENT);
            text.append(key).append(field ? ": " : ":=").append(value).append('\n');
        });
        return text.append('\n').toString();
    }
}
