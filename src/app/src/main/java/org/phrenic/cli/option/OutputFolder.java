package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import org.phrenic.file.BadInputException;

/** Checks the output folder of a command. */
public final class OutputFolder {
    private OutputFolder() {}

    /**
     * Checks, before any computation, that a folder can be created or written to. Creates nothing.
     *
     * @throws BadInputException if the folder is not writable; the message is one sentence
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
