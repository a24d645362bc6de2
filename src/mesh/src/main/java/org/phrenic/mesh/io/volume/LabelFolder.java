package org.phrenic.mesh.io.volume;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.raster.SeveralValuesException;
import org.phrenic.mesh.io.raster.VolumeFormats;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Reads the label volumes of a folder, whose voxels lie on one lattice ({@link LabelLattice}), as one volume: for
 * example a folder with one binary mask per structure. A mask has the name of its file, unless the file itself names it
 * otherwise than by a number; labels of a file with several have their names in it. Images are left out. Where
 * structures overlap, a voxel belongs to the one with the fewest voxels ({@link LabelPainter}).
 */
final class LabelFolder {
    private static final String THORAX_INDEX = "thorax.yaml";
    /** Files read at the same time, each with all of its voxels in memory. */
    private static final int AT_ONCE = 2;

    private LabelFolder() {}

    /**
     * The label volumes in a folder.
     *
     * @param notes what is left out
     * @param several refusals of files whose voxels have several values
     */
    private record Contents(
            Path folder, List<LabelRuns> labelled, List<String> notes, List<SeveralValuesException> several) {
        /** Whether the folder holds one volume of several labels without names. */
        boolean isUnnamed() {
            return labelled.size() == 1 && labelled.get(0).isUnnamed();
        }

        /** The volumes as one; empty if there are none. */
        Optional<LabelVolume> merged() {
            if (labelled.size() == 1 && labelled.get(0).hasOwnLabels()) {
                Path file = labelled.get(0).file();
                return Optional.of(LabelVolumeFiles.read(file).in(file).withNotesBefore(notes));
            }
            return labelled.isEmpty() ? Optional.empty() : Optional.of(painted(folder, labelled, notes));
        }
    }

    /** The labels of a file, or its refusal if its voxels have several values; neither for other images. */
    record Volume(Optional<LabelRuns> labels, Optional<SeveralValuesException> several) {
        static Volume read(Path file) {
            try {
                return new Volume(LabelRuns.read(file), Optional.empty());
            } catch (SeveralValuesException refusal) {
                return new Volume(Optional.empty(), Optional.of(refusal));
            }
        }
    }

    /** Whether a folder holds meshes, or their list. */
    static boolean isOfMeshes(Path folder) {
        return InputBytes.list(folder).stream().anyMatch(file -> MeshFiles.isMesh(file) || file.endsWith(THORAX_INDEX));
    }

    /** Whether a folder holds volumes, itself or in a folder in it, and is no thorax folder. */
    static boolean isLabelFolder(Path folder) {
        return Files.isDirectory(folder)
                && !isOfMeshes(folder)
                && (!InnerFolders.volumes(folder).isEmpty()
                        || !InnerFolders.ofVolumes(folder).isEmpty());
    }

    /**
     * Reads the label volumes of a folder or, if it has none, of the folder in it that has. Masks in a folder within
     * are preferred to a volume of the same labels without names, and join masks with other names.
     *
     * @throws BadInputException if a volume cannot be read, if there is none, if grids differ, or if there are labels
     *     of several scans
     */
    static LabelVolume read(Path folder) {
        return read(folder, InnerFolders.MAX_DEPTH);
    }

    /** @param levels levels of folders within that are looked into: links of two folders may lead round in a circle */
    private static LabelVolume read(Path folder, int levels) {
        Contents own = contents(folder);
        if (own.labelled().isEmpty()) {
            Optional<Path> inner = levels > 0 ? InnerFolders.ofLabels(folder) : Optional.empty();
            return inner.map(path -> read(path, levels - 1).withNotesBefore(own.notes()))
                    .orElseThrow(() -> own.several().isEmpty()
                            ? none(folder)
                            : own.several().get(0));
        }
        return InnerFolders.calledLabels(folder)
                .flatMap(inner -> withMasks(own, inner))
                .or(own::merged)
                .orElseThrow();
    }

    /**
     * The masks of a folder within, in place of the volume beside it or together with the masks there. Empty if they
     * are left out, which the notes of the volumes then say.
     */
    private static Optional<LabelVolume> withMasks(Contents own, Path inner) {
        String left = inner.getFileName() + " is left out, as ";
        try {
            Contents masks = contents(inner);
            if (masks.labelled().isEmpty()) {
                return Optional.empty();
            }
            Optional<String> objection = MaskMatch.objection(own.labelled(), masks.labelled());
            if (objection.isPresent()) {
                own.notes().add(left + objection.get());
                return Optional.empty();
            }
            String beside = InnerFolders.listed(
                    own.labelled().stream().map(LabelRuns::file).toList());
            if (own.isUnnamed()) {
                own.notes().add(beside + " is left out, as " + inner.getFileName() + " holds masks with names");
                return masks.merged().map(volume -> volume.withNotesBefore(own.notes()));
            }
            List<LabelRuns> all = new ArrayList<>(own.labelled());
            all.addAll(masks.labelled());
            List<String> notes = new ArrayList<>(own.notes());
            notes.addAll(masks.notes());
            notes.add("the masks of " + inner.getFileName() + " are taken together with " + beside);
            return Optional.of(painted(own.folder(), all, notes));
        } catch (BadInputException unfit) {
            own.notes().add(left + "it cannot be taken with what lies beside it: " + unfit.getMessage());
            return Optional.empty();
        }
    }

    private static BadInputException none(Path folder) {
        // Beside the images of a scan there may be others of it farther within.
        if (InnerFolders.volumes(folder).isEmpty() || InnerFolders.holdsLabelsDeeper(folder)) {
            LabelVolumeFiles.refuseDeeper(folder, "a label volume");
        }
        return new BadInputException(
                folder + ": found no label volume, expected one: images have to be segmented first");
    }

    /** Reads the label volumes of a folder. */
    private static Contents contents(Path folder) {
        List<Path> files = InnerFolders.volumes(folder);
        Contents contents = new Contents(folder, new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (int first = 0; first < files.size(); first += AT_ONCE) {
            List<Path> now = files.subList(first, Math.min(first + AT_ONCE, files.size()));
            List<Volume> read = now.parallelStream().map(Volume::read).toList();
            for (int f = 0; f < now.size(); f++) {
                if (read.get(f).labels().isPresent()) {
                    contents.labelled().add(read.get(f).labels().get());
                } else if (read.get(f).several().isPresent()) {
                    contents.several().add(read.get(f).several().get());
                    contents.notes().add(now.get(f).getFileName() + " has several values a voxel and is left out");
                } else if (VolumeFormats.isVolume(now.get(f))) {
                    contents.notes().add(now.get(f).getFileName() + " is an image and is left out");
                }
            }
            requireOneScan(contents);
            if (!contents.labelled().isEmpty()) {
                // Of the masks of many scans the second one is refused here, and the others are not read.
                new LabelLattice(contents.labelled());
            }
        }
        return contents;
    }

    /** Refuses volumes of several labels without names, as those of the scans of a data set. */
    private static void requireOneScan(Contents contents) {
        List<Path> unnamed = contents.labelled().stream()
                .filter(LabelRuns::isUnnamed)
                .map(LabelRuns::file)
                .toList();
        if (unnamed.size() > 1) {
            throw new BadInputException(contents.folder() + ": found several volumes of labels without names ("
                    + InnerFolders.listed(unnamed) + "), expected the labels of one scan, such as " + unnamed.get(0));
        }
    }

    private static LabelVolume painted(Path folder, List<LabelRuns> labelled, List<String> notes) {
        LabelLattice lattice = new LabelLattice(labelled);
        LabelPainter painter = lattice.painter(folder.toString());
        Map<Integer, String> names = new TreeMap<>();
        for (LabelRuns file : labelled) {
            file.requireNames();
            requireOwnNames(file, labelled);
            for (int s = 0; s < file.structures().size(); s++) {
                names.put(names.size() + 1, file.names().get(s));
                painter.add(names.size(), lattice.voxels(file, file.structures().get(s)));
            }
            notes.addAll(file.notes());
        }
        LabelGrid grid = painter.grid(lattice.toMm(), notes);
        if (!lattice.isCropped()) {
            return new LabelVolume(grid, names, notes);
        }
        notes.add("masks of different extents were put together");
        return new LabelVolume(grid, names, notes).with(LabelVolume.Extent.LABELS);
    }

    /** Refuses files of which two segment the same structures, as those of two breaths do. */
    private static void requireOwnNames(LabelRuns file, List<LabelRuns> all) {
        for (LabelRuns other : all.subList(0, all.indexOf(file))) {
            List<String> both =
                    file.names().stream().filter(other.names()::contains).toList();
            if (both.size() > 1) {
                throw new BadInputException(file.file() + ": found "
                        + both.subList(0, 2).stream().map(Numbers::quote).collect(Collectors.joining(" and "))
                        + " as in "
                        + other.file().getFileName() + ", expected the labels of one scan");
            }
        }
    }
}
