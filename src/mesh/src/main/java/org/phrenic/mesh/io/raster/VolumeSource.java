package org.phrenic.mesh.io.raster;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A volume as the user names it: a file, and the phase if the file holds several volumes. {@code scan.nii.gz#2} is the
 * third volume of {@code scan.nii.gz}; an existing file of that whole name comes first.
 *
 * @param path the file
 * @param phase number of the volume, from 0; empty if none was named
 */
public record VolumeSource(Path path, OptionalInt phase) {
    private static final Pattern PHASE = Pattern.compile("(.+)#(\\d{1,6})");

    /** The file and phase that a path names. */
    public static VolumeSource of(Path named) {
        Matcher phase = PHASE.matcher(String.valueOf(named.getFileName()));
        if (!phase.matches() || Files.exists(named)) {
            return new VolumeSource(named, OptionalInt.empty());
        }
        return new VolumeSource(named.resolveSibling(phase.group(1)), OptionalInt.of(Integer.parseInt(phase.group(2))));
    }
}
