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
import org.phrenic.file.FileNames;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.MeshFiles;
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

    /** Whether a folder holds volumes, itself or in a folder in it, and is no thorax folder. */
    static boolean isLabelFolder(Path folder) {
        return Files.isDirectory(folder)
                && InputBytes.list(folder).stream()
                        .noneMatch(file -> MeshFiles.isMesh(file) || file.endsWith(THORAX_INDEX))
                && (!volumes(folder).isEmpty() || !innerFolders(folder).isEmpty());
    }

    private static List<Path> volumes(Path folder) {
        return InputBytes.list(folder).stream()
                .filter(file -> Files.isRegularFile(file)
                        && !FileNames.isHidden(file)
                        && (VolumeFormats.isVolume(file) || DicomVolumes.isDicom(file)))
                .toList();
    }

    /** The folders in a folder that hold volumes; hidden ones and those that may not be read are left out. */
    private static List<Path> innerFolders(Path folder) {
        return InputBytes.list(folder).stream()
                .filter(inner -> Files.isDirectory(inner)
                        && Files.isReadable(inner)
                        && !FileNames.isHidden(inner)
                        && !volumes(inner).isEmpty())
                .toList();
    }

    /**
     * Reads the label volumes of a folder or, if it has none, of the folder in it that has.
     *
     * @throws BadInputException if a volume cannot be read, if there is none, or if grids differ
     */
    static LabelVolume read(Path folder) {
        Optional<LabelVolume> own = merged(folder);
        if (own.isPresent()) {
            return own.get();
        }
        List<Path> inner = innerFolders(folder);
        if (inner.size() > 1) {
            throw new BadInputException(folder + ": found volumes in several folders ("
                    + inner.stream().map(path -> path.getFileName().toString()).collect(Collectors.joining(", "))
                    + "), expected the labels of one scan");
        }
        return inner.stream()
                .findFirst()
                .flatMap(LabelFolder::merged)
                .orElseThrow(() -> new BadInputException(
                        folder + ": found no label volume, expected one: images have to be segmented first"));
    }

    /** The label volumes of a folder as one; empty if it has none. */
    private static Optional<LabelVolume> merged(Path folder) {
        List<Path> files = volumes(folder);
        List<LabelRuns> labelled = new ArrayList<>();
        List<String> notes = new ArrayList<>();
        for (int first = 0; first < files.size(); first += AT_ONCE) {
            List<Path> now = files.subList(first, Math.min(first + AT_ONCE, files.size()));
            List<Optional<LabelRuns>> read =
                    now.parallelStream().map(LabelRuns::read).toList();
            for (int f = 0; f < now.size(); f++) {
                if (read.get(f).isPresent()) {
                    labelled.add(read.get(f).get());
                } else if (VolumeFormats.isVolume(now.get(f))) {
                    notes.add(now.get(f).getFileName() + " is an image and is left out");
                }
            }
        }
        if (labelled.size() == 1 && hasOwnLabels(labelled.get(0))) {
            LabelVolume volume = LabelVolumeFiles.read(labelled.get(0).file());
            notes.addAll(volume.notes());
            return Optional.of(new LabelVolume(volume.grid(), volume.names(), notes));
        }
        return labelled.isEmpty() ? Optional.empty() : Optional.of(painted(folder, labelled, notes));
    }

    /** Whether a volume is more than a mask: it has several structures, or one without a name. */
    private static boolean hasOwnLabels(LabelRuns volume) {
        return volume.structures().size() > 1 || volume.names().contains("");
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
        return new LabelVolume(EmptySlices.beyond(grid), names, notes);
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
