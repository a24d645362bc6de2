package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import picocli.CommandLine.Option;

/** The option for the folder of the reports, and the check of folders that commands write into. */
public final class ReportFolder {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path folder;

    /** Checks as {@link #requireWritable} does. */
    public void check() {
        if (folder != null) {
            requireWritable(folder);
        }
    }

    /**
     * Checks, before any computation, that a folder can be created or written to. Creates nothing.
     *
     * @throws BadInputException if the folder is not writable; the message is one sentence
     */
    public static Path requireWritable(Path folder) {
        if (folder.toString().isEmpty()) {
            throw new BadInputException("--out: found an empty name, expected a folder");
        }
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

    public void write(String file, String text) {
        if (folder != null) {
            AtomicFile.write(folder.resolve(file), text);
        }
    }

    public void write(String file, Map<String, ?> values) {
        if (folder != null) {
            JsonWriter.write(folder.resolve(file), values);
        }
    }
}
