package org.phrenic.study.fit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;

/**
 * Two label volumes of one patient: {@code NAME_expiration.nii.gz} and {@code NAME_inspiration.nii.gz}, or other
 * readable formats. A patient of whom one is missing has the path at which it would be.
 *
 * @param name of the patient
 * @param expiration lungs at end-expiration
 * @param inspiration lungs at end-inspiration
 */
public record PatientScans(String name, Path expiration, Path inspiration) {
    private static final String EXPIRATION = "_expiration.";
    private static final String INSPIRATION = "_inspiration.";

    /**
     * Finds the patients of a folder, sorted by name, also those of whom one scan is missing.
     *
     * @throws BadInputException if there is no pair
     */
    public static List<PatientScans> findIn(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new BadInputException(folder + ": found no folder, expected one with scans of patients");
        }
        List<Path> scans;
        try (Stream<Path> files = Files.list(folder)) {
            scans = FileNames.sorted(
                    files.filter(file -> !FileNames.isHidden(file) && LabelVolumeFiles.isVolume(file)));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        Map<String, PatientScans> expired = new LinkedHashMap<>();
        for (Path scan : scans) {
            if (isOf(scan, EXPIRATION)) {
                Path other = partner(scan, EXPIRATION, INSPIRATION, scans);
                PatientScans patient = new PatientScans(name(scan, EXPIRATION), scan, other);
                // Of one scan in two formats that counts whose partner has the same.
                expired.merge(
                        patient.name, patient, (first, next) -> !first.isAlike() && next.isAlike() ? next : first);
            }
        }
        List<PatientScans> patients = new ArrayList<>(expired.values());
        for (Path scan : scans) {
            if (isOf(scan, INSPIRATION) && patients.stream().noneMatch(p -> p.name.equals(name(scan, INSPIRATION)))) {
                patients.add(
                        new PatientScans(name(scan, INSPIRATION), partner(scan, INSPIRATION, EXPIRATION, scans), scan));
            }
        }
        if (patients.stream().noneMatch(PatientScans::isPair)) {
            throw new BadInputException(folder
                    + ": found no pair of volumes, expected NAME_expiration.nii.gz and NAME_inspiration.nii.gz"
                    + " or the like");
        }
        patients.sort(Comparator.comparing(PatientScans::name));
        return patients;
    }

    private static boolean isOf(Path scan, String level) {
        return scan.getFileName().toString().contains(level);
    }

    private static String name(Path scan, String level) {
        String file = scan.getFileName().toString();
        return file.substring(0, file.indexOf(level));
    }

    /** The scan of the same patient at the other level: that of the same ending if there is one, else the first. */
    private static Path partner(Path scan, String level, String other, List<Path> scans) {
        Path alike = scan.resolveSibling(scan.getFileName().toString().replace(level, other));
        return scans.contains(alike)
                ? alike
                : scans.stream()
                        .filter(s -> isOf(s, other) && name(s, other).equals(name(scan, level)))
                        .findFirst()
                        .orElse(alike);
    }

    /** Whether both scans are there. */
    public boolean isPair() {
        return Files.exists(expiration) && Files.exists(inspiration);
    }

    private boolean isAlike() {
        String alike = expiration.getFileName().toString().replace(EXPIRATION, INSPIRATION);
        return isPair() && inspiration.getFileName().toString().equals(alike);
    }

    /** @throws BadInputException if one of the scans is missing */
    public void requireBoth() {
        if (!isPair()) {
            boolean expired = Files.exists(expiration);
            throw new BadInputException((expired ? expiration : inspiration) + ": found no " + name
                    + (expired ? INSPIRATION : EXPIRATION) + "* beside it, expected a volume with one of the endings "
                    + String.join(", ", LabelVolumeFiles.READABLE));
        }
    }
}
