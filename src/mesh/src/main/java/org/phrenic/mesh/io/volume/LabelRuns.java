package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.io.raster.NoLabelException;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * The labels of one of several volumes on one grid, run-length encoded.
 *
 * @param file where they were read from
 * @param size columns, rows and slices
 * @param toMm affine matrix of the grid, see {@link LabelGrid}
 * @param structures the voxels of each label
 * @param names their names: in the file, or that of the file if it has one label whose name is no more than a number;
 *     empty where there is none
 * @param notes assumptions about missing information, one sentence each
 */
record LabelRuns(Path file, int[] size, double[] toMm, List<Runs> structures, List<String> names, List<String> notes) {
    /** The voxels of a structure: the first of each run and the one after its last. */
    record Runs(IntList ends) implements LabelPainter.Voxels {
        @Override
        public void forEach(IntConsumer voxel) {
            for (int run = 0; run < ends.size(); run += 2) {
                for (int v = ends.get(run); v < ends.get(run + 1); v++) {
                    voxel.accept(v);
                }
            }
        }
    }

    /**
     * Reads a file; empty if it holds an image.
     *
     * @throws org.phrenic.mesh.io.raster.SeveralValuesException if its voxels have several values
     * @throws BadInputException if it cannot be read
     */
    static Optional<LabelRuns> read(Path file) {
        if (DicomVolumes.isDicom(file) && !DicomVolumes.holdsLabels(file)) {
            return Optional.empty();
        }
        try {
            LabelVolume volume = LabelVolumeFiles.read(file);
            int[] counts = volume.grid().counts();
            int[] labels = IntStream.range(1, counts.length)
                    .filter(label -> counts[label] > 0)
                    .toArray();
            return volume.isImage() ? Optional.empty() : Optional.of(of(file, volume, labels));
        } catch (NoLabelException image) {
            return Optional.empty();
        }
    }

    private static LabelRuns of(Path file, LabelVolume volume, int[] labels) {
        LabelGrid grid = volume.grid();
        String name = labels.length == 1
                ? String.valueOf(file.getFileName()).replaceFirst("(?i)(\\.seg|\\.nii)?\\.[a-z]*$", "")
                : "";
        List<String> names = Arrays.stream(labels)
                .mapToObj(label -> volume.names().getOrDefault(label, ""))
                .map(own -> labels.length == 1 && LabelVolume.isNumber(own) ? name : own)
                .toList();
        return new LabelRuns(
                file,
                new int[] {grid.columns(), grid.rows(), grid.slices()},
                grid.toMm(),
                runs(grid, labels),
                names,
                volume.notes());
    }

    private static List<Runs> runs(LabelGrid grid, int[] labels) {
        int[] structureOf = new int[LabelGrid.MAX_LABEL + 1];
        List<Runs> structures = new ArrayList<>();
        for (int label : labels) {
            structures.add(new Runs(new IntList()));
            structureOf[label] = structures.size();
        }
        int voxels = grid.voxelCount();
        int before = 0;
        for (int v = 0; v <= voxels; v++) {
            int now = v < voxels ? structureOf[grid.label(v)] : 0;
            if (now != before) {
                if (before > 0) {
                    structures.get(before - 1).ends().add(v);
                }
                if (now > 0) {
                    structures.get(now - 1).ends().add(v);
                }
                before = now;
            }
        }
        return structures;
    }

    /** Whether the volume has several labels and one of them has no name. */
    boolean isUnnamed() {
        return structures.size() > 1 && names.contains("");
    }

    /** Whether the volume is more than a mask: it has several structures, or one without a name. */
    boolean hasOwnLabels() {
        return structures.size() > 1 || names.contains("");
    }

    /** @throws BadInputException if a label has no name */
    void requireNames() {
        if (names.contains("")) {
            throw new BadInputException(file + ": found labels without names beside other volumes, expected a mask,"
                    + " or this volume alone");
        }
    }
}
