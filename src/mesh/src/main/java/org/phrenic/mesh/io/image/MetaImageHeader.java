package org.phrenic.mesh.io.image;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.mesh.voxel.VoxelBox;

/** The header of a MetaImage, uncompressed, LPS, with the voxels in the same file; the comment says what they are. */
final class MetaImageHeader {
    private MetaImageHeader() {}

    /** The header; voxels follow at once. */
    static String text(VoxelSeries series) {
        VoxelBox box = series.box();
        double[] m = box.toMm();
        String directions = IntStream.range(0, 9)
                .mapToObj(n -> " " + m[4 * (n % 3) + n / 3] / box.spacing(n / 3))
                .collect(Collectors.joining());
        String type =
                switch (series.type()) {
                    case UINT8 -> "MET_UCHAR";
                    case UINT16 -> "MET_USHORT";
                    case INT16 -> "MET_SHORT";
                    default -> "MET_FLOAT";
                };
        String about = series.about().entrySet().stream()
                .map(e -> e.getKey().equals(VoxelSeries.CONTENT) ? e.getValue() : e.getKey() + " = " + e.getValue())
                .collect(Collectors.joining("; "));
        return "ObjectType = Image\nNDims = 3\nComment = " + about
                + "\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\nTransformMatrix ="
                + directions + "\nOffset = " + m[3] + " " + m[7] + " " + m[11] + "\nElementSpacing = " + box.spacing(0)
                + " " + box.spacing(1) + " " + box.spacing(2) + "\nDimSize =" + joined(box.size())
                + "\nElementNumberOfChannels = " + series.components() + "\nElementType = " + type
                + "\nElementDataFile = LOCAL\n";
    }

    /** Numbers, each after a space. */
    static String joined(int[] numbers) {
        return IntStream.of(numbers).mapToObj(n -> " " + n).collect(Collectors.joining());
    }
}
