package org.phrenic.mesh.io.volume;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.InputBytes;
import org.phrenic.mesh.io.raster.VolumeFormats;

/** The folders within the folder of a scan, of which one holds its labels and others may hold images. */
final class InnerFolders {
    /** Names that data sets and programs give to folders of labels, such as nnU-Net's labelsTr. */
    private static final Pattern LABELS =
            Pattern.compile("(?i)(segs?|(gt_)?segmentations?|labels?(tr|ts|va)?|masks?|annotations?|structures?)");
    /** Names of folders of images. */
    private static final Pattern IMAGES =
            Pattern.compile("(?i)(images?(tr|ts|va)?|imgs?|scans?|cts?|mrs?|mris?|dicoms?|raw(data)?)");
    /** Most folders of which the first volumes are read to see whether they are labels. */
    private static final int MAX_LOOKED_INTO = 6;

    /** Number of volumes of such a folder that are read: a scan, and labels beside it. */
    private static final int FEW = 2;

    private static final int MAX_LISTED = 4;
    /** Levels of folders that are looked through for volumes, and most folders. */
    static final int MAX_DEPTH = 5;

    private static final int MAX_SEARCHED = 500;

    private InnerFolders() {}

    /** The volumes in a folder; hidden files are left out. */
    static List<Path> volumes(Path folder) {
        return InputBytes.list(folder).stream()
                .filter(file -> Files.isRegularFile(file)
                        && !FileNames.isHidden(file)
                        && (VolumeFormats.isVolume(file) || DicomVolumes.isDicom(file)))
                .toList();
    }

    /** The folders in a folder; hidden ones, those that may not be read and links to what holds it are left out. */
    private static List<Path> folders(Path folder) {
        return InputBytes.list(folder).stream()
                .filter(inner -> Files.isDirectory(inner) && Files.isReadable(inner) && !FileNames.isHidden(inner))
                .filter(inner -> !(Files.isSymbolicLink(inner) && leadsBack(inner, folder)))
                .toList();
    }

    private static boolean leadsBack(Path link, Path folder) {
        try {
            return folder.toRealPath().startsWith(link.toRealPath());
        } catch (IOException unreadable) {
            return true;
        }
    }

    /** The folders in a folder that hold volumes. */
    static List<Path> ofVolumes(Path folder) {
        return folders(folder).stream()
                .filter(inner -> !volumes(inner).isEmpty())
                .toList();
    }

    /**
     * The folder in a folder that holds labels: the one that is called so, or else the only one that is not called
     * after images and holds no images; if all are called after images, the only one that holds none.
     *
     * @throws BadInputException if there are several
     */
    static Optional<Path> ofLabels(Path folder) {
        List<Path> inner = ofVolumes(folder);
        if (inner.size() > 1) {
            Optional<Path> labels = calledLabels(folder);
            if (labels.isPresent()) {
                return labels;
            }
            List<Path> others =
                    inner.stream().filter(path -> !isCalled(path, IMAGES)).toList();
            inner = others.isEmpty() ? inner : others;
        }
        if (inner.size() > 1 && inner.size() <= MAX_LOOKED_INTO) {
            inner = inner.stream().filter(InnerFolders::holdsLabels).toList();
        }
        if (inner.size() > 1) {
            throw new BadInputException(folder + ": found volumes in " + inner.size() + " folders (" + listed(inner)
                    + "), expected the labels of one scan, such as " + inner.get(0));
        }
        return inner.stream().findFirst();
    }

    /** The only folder with volumes in a folder that is called as folders of labels are; empty without one. */
    static Optional<Path> calledLabels(Path folder) {
        List<Path> called =
                ofVolumes(folder).stream().filter(InnerFolders::isCalledLabels).toList();
        return called.size() == 1 ? Optional.of(called.get(0)) : Optional.empty();
    }

    static boolean isCalledLabels(Path folder) {
        return isCalled(folder, LABELS);
    }

    private static boolean isCalled(Path folder, Pattern names) {
        return names.matcher(String.valueOf(folder.getFileName())).matches();
    }

    private static boolean holdsLabels(Path folder) {
        return !ofVolumes(folder).isEmpty() || startsWithLabels(folder);
    }

    /** Whether one of the first volumes in a folder holds labels. */
    private static boolean startsWithLabels(Path folder) {
        return volumes(folder).stream()
                .limit(FEW)
                .anyMatch(file -> LabelFolder.Volume.read(file).labels().isPresent());
    }

    /** Whether the first folder with volumes somewhere within a folder holds labels that can be read. */
    static boolean holdsLabelsDeeper(Path folder) {
        try {
            return deeper(folder).filter(InnerFolders::startsWithLabels).isPresent();
        } catch (BadInputException unreadable) {
            return false;
        }
    }

    /** The first folder, level by level, that holds volumes somewhere within a folder. */
    static Optional<Path> deeper(Path folder) {
        List<Path> level = folders(folder);
        int searched = 0;
        for (int depth = 0; depth < MAX_DEPTH && searched < MAX_SEARCHED; depth++) {
            List<Path> next = level.stream()
                    .limit(MAX_SEARCHED)
                    .flatMap(f -> folders(f).stream())
                    .toList();
            Optional<Path> found = next.stream()
                    .limit(MAX_SEARCHED)
                    .filter(inner -> !volumes(inner).isEmpty())
                    .findFirst();
            if (found.isPresent()) {
                return found;
            }
            searched += next.size();
            level = next;
        }
        return Optional.empty();
    }

    /** Names of files, as many as a sentence can hold. */
    static String listed(List<Path> files) {
        String names = files.stream()
                .limit(MAX_LISTED)
                .map(path -> path.getFileName().toString())
                .collect(Collectors.joining(", "));
        return files.size() > MAX_LISTED ? names + " ..." : names;
    }
}
