package org.phrenic.mesh.io.volume;

import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.raster.VoxelDecoder;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Makes one label of each voxel from structures that may overlap: it belongs to the structure with the fewest voxels,
 * so that a lesion stays in its organ and organs stay in the outline of the body; of equal ones to the later.
 */
final class LabelPainter {
    /** The voxels of a structure, one after the other; a voxel may come twice. */
    interface Voxels {
        void forEach(IntConsumer voxel);
    }

    private record Structure(int label, Voxels voxels, long count) {}

    private final String file;
    private final VoxelDecoder size;
    private final int columns;
    private final int rows;
    private final int slices;
    private final List<Structure> structures = new ArrayList<>();
    private byte[] bytes = new byte[0];
    private short[] shorts = new short[0];

    /** @throws BadInputException if the labels of so many voxels do not fit into memory */
    LabelPainter(String file, int columns, int rows, int slices) {
        size = new VoxelDecoder(new int[] {columns, rows, slices}, ScalarType.UINT8, ByteOrder.LITTLE_ENDIAN);
        size.validate(file, Long.MAX_VALUE, false, 1);
        this.file = file;
        this.columns = columns;
        this.rows = rows;
        this.slices = slices;
    }

    /** Adds a structure, whose voxels are asked for twice; returns their number. */
    long add(int label, Voxels voxels) {
        long[] count = new long[1];
        voxels.forEach(voxel -> count[0]++);
        add(label, voxels, count[0]);
        return count[0];
    }

    /** Adds a structure of which the number of voxels is known. */
    void add(int label, Voxels voxels, long count) {
        structures.add(new Structure(label, voxels, count));
    }

    /**
     * The grid with all structures.
     *
     * @param notes receives a sentence if structures overlap
     */
    LabelGrid grid(double[] affine, List<String> notes) {
        allocate(structures.stream().mapToInt(Structure::label).max().orElse(0));
        structures.sort(Comparator.comparingLong((Structure s) -> -s.count()));
        long[] covered = new long[1];
        for (Structure structure : structures) {
            structure.voxels().forEach(voxel -> {
                int before = set(voxel, structure.label());
                covered[0] += before != 0 && before != structure.label() ? 1 : 0;
            });
        }
        if (covered[0] > 0) {
            notes.add("structures overlap (" + covered[0]
                    + " times in a voxel): such a voxel belongs to the one with the fewest voxels");
        }
        return grid(affine);
    }

    /**
     * Makes room for labels up to {@code largest}.
     *
     * @throws BadInputException if they do not fit into memory
     */
    void allocate(int largest) {
        boolean small = largest <= LabelGrid.MAX_BYTE_LABEL;
        size.checkMemory(file, small ? Byte.BYTES : Short.BYTES);
        bytes = new byte[small ? columns * rows * slices : 0];
        shorts = new short[small ? 0 : columns * rows * slices];
    }

    /** Gives a voxel a label; returns the one that it had. */
    int set(int voxel, int label) {
        if (shorts.length > 0) {
            int before = shorts[voxel] & LabelGrid.MAX_LABEL;
            shorts[voxel] = (short) label;
            return before;
        }
        int before = bytes[voxel] & LabelGrid.MAX_BYTE_LABEL;
        bytes[voxel] = (byte) label;
        return before;
    }

    /** The grid with the labels that were set. */
    LabelGrid grid(double[] affine) {
        return shorts.length > 0
                ? LabelGrid.of(columns, rows, slices, shorts, affine)
                : LabelGrid.of(columns, rows, slices, bytes, affine);
    }

    /** The names of structures without those that are empty. */
    static Map<Integer, String> named(Map<Integer, String> names) {
        names.values().removeIf(String::isBlank);
        return names;
    }
}
