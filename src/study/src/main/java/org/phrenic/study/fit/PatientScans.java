package org.phrenic.study.fit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;

/**
 * Two label volumes of one patient: {@code NAME_expiration.nii.gz} and {@code NAME_inspiration.nii.gz}, or another
 * readable format.
 *
 * @param name of the patient
 * @param expiration lungs at end-expiration
 * @param inspiration lungs at end-inspiration
 */
public record PatientScans(String name, Path expiration, Path inspiration) {
    private static final String EXPIRATION = "_expiration.";
    private static final String INSPIRATION = "_inspiration.";

    /**
     * Finds all pairs of a folder, sorted by name.
     *
     * @throws BadInputException if there are none
     */
    public static List<PatientScans> findIn(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new BadInputException(folder + ": found no folder, expected one with scans of patients");
        }
        List<PatientScans> pairs = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : FileNames.sorted(files)) {
                String name = file.getFileName().toString();
                Path other = file.resolveSibling(name.replace(EXPIRATION, INSPIRATION));
                if (name.contains(EXPIRATION) && LabelVolumeFiles.isVolume(file) && Files.isRegularFile(other)) {
                    pairs.add(new PatientScans(name.substring(0, name.indexOf(EXPIRATION)), file, other));
                }
            }
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        if (pairs.isEmpty()) {
            throw new BadInputException(folder
                    + ": found no pair of volumes, expected NAME_expiration.nii.gz and NAME_inspiration.nii.gz"
                    + " or the like");
        }
        return pairs;
    }
}
