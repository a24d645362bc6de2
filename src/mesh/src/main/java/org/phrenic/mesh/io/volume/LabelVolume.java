package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * A label volume read from a file, in LPS axes and mm.
 *
 * @param grid labels and their positions
 * @param names names of labels, if the file contains them
 * @param notes assumptions about missing information, one sentence each
 * @param file the file in a folder whose labels these are, with its numbers; empty for a file that is read by itself
 *     and for the masks of a folder
 * @param extent what is known of the box of the grid
 */
public record LabelVolume(
        LabelGrid grid, Map<Integer, String> names, List<String> notes, Optional<Path> file, Extent extent) {
    /** What a grid holds besides voxels with labels. */
    public enum Extent {
        /** The field of view, or what the file was cropped to. */
        FIELD,
        /** Slices without labels are left out. */
        LABELLED_SLICES,
        /** Voxels beyond the box of all structures are left out. */
        LABELS
    }

    private static final Pattern NUMBER = Pattern.compile("(?i)(segment|seg|label)?[ _.-]*\\d*");

    /** A volume without names that has more labels is an image of whole numbers. */
    private static final int MAX_UNNAMED_LABELS = 500;
    /** Least number of labels of an image whose voxels differ from their neighbours. */
    private static final int LEAST_GREY_VALUES = 40;
    /** Mean length of runs of one label along columns, voxels, below which labels are grey values. */
    private static final double LEAST_RUN = 2;

    public LabelVolume {
        names = Collections.unmodifiableMap(new TreeMap<>(names));
        notes = List.copyOf(notes);
    }

    /** Creates a volume of a file that is read by itself, or of masks. */
    public LabelVolume(LabelGrid grid, Map<Integer, String> names, List<String> notes) {
        this(grid, names, notes, Optional.empty(), Extent.FIELD);
    }

    /** A copy of which more is known. */
    LabelVolume with(Extent known) {
        return new LabelVolume(grid, names, notes, file, known);
    }

    /** A copy with further notes before its own. */
    LabelVolume withNotesBefore(List<String> further) {
        List<String> all = new ArrayList<>(further);
        all.addAll(notes);
        return new LabelVolume(grid, names, all, file, extent);
    }

    /** A copy whose labels are those of a file in a folder. */
    LabelVolume in(Path found) {
        return new LabelVolume(grid, names, notes, Optional.of(found), extent);
    }

    /** A copy with its voxels elsewhere. */
    public LabelVolume withGrid(LabelGrid moved) {
        return new LabelVolume(moved, names, notes, file, extent);
    }

    /**
     * A copy of a volume that is cropped to its structures, with an empty layer beyond each face at which all those end
     * that touch it: there the scan does not end. Structures of a volume that is not known to be cropped touch all six
     * faces, else it stays as it is.
     */
    public LabelVolume withEmptyLayers() {
        LabelGrid padded = EmptyLayers.beyond(grid, extent);
        return padded == grid ? this : withGrid(padded);
    }

    /** Whether a name is a mere number, as programs give to labels without a name: Segment 1, Label 2, 3. */
    public static boolean isNumber(String name) {
        return NUMBER.matcher(name).matches();
    }

    /**
     * Whether the volume is an image of whole numbers, as of MR: it has very many labels without names, or many that
     * change from voxel to voxel.
     */
    public boolean isImage() {
        if (!names.isEmpty()) {
            return false;
        }
        int[] counts = grid.counts();
        long labels = Arrays.stream(counts, 1, Math.max(1, counts.length))
                .filter(count -> count > 0)
                .count();
        return labels > MAX_UNNAMED_LABELS || (labels >= LEAST_GREY_VALUES && meanRun() < LEAST_RUN);
    }

    /** Mean number of neighbouring voxels along columns with one label. */
    private double meanRun() {
        long labelled = 0;
        long runs = 0;
        for (int v = 0; v < grid.voxelCount(); v++) {
            int label = grid.label(v);
            if (label > 0) {
                labelled++;
                runs += v % grid.columns() > 0 && grid.label(v - 1) == label ? 0 : 1;
            }
        }
        return (double) labelled / Math.max(1, runs);
    }
}
