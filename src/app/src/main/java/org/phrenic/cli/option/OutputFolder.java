package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import org.phrenic.file.BadInputException;

/** The folder into which a command writes. */
public final class OutputFolder {
    private OutputFolder() {}

    /**
     * Refuses a folder that cannot be created or written to, before anything is computed; creates nothing.
     *
     * @throws BadInputException with one sentence
     */
    public static Path requireWritable(Path folder) {
        Path nearest = folder.toAbsolutePath();
        while (nearest != null && !Files.exists(nearest)) {
            nearest = nearest.getParent();
        }
        if (nearest == null || !Files.isDirectory(nearest)) {
            throw new BadInputException("--out " + folder + ": found the file " + nearest + ", expected a folder");
        }
        if (!Files.isWritable(nearest)) {
            throw new BadInputException("--out " + folder + ": found no permission to write into " + nearest
                    + ", expected a folder of yours");
        }
        return folder;
    }
}
