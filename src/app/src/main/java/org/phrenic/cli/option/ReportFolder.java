package org.phrenic.cli.option;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ExistingPath;
import org.phrenic.file.InputBytes;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The option for the folder of the reports, and the check of folders that commands write into. */
public final class ReportFolder {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path folder;

    /** Checks as {@link #requireWritable(Path)} does; without a folder, that no line of a report is stated. */
    public void check() {
        if (folder != null) {
            requireWritable(folder);
        } else if (command.commandLine().getParseResult().hasMatchedOption("--made-by")) {
            throw new BadInputException("--made-by: found it without --out, expected both");
        }
    }

    /**
     * Checks, before any computation, that a folder can be created or written to. Creates nothing.
     *
     * @throws BadInputException if the folder is not writable; the message is one sentence
     */
    public static Path requireWritable(Path folder) {
        return requireWritable("--out", folder);
    }

    /**
     * Checks the folder of a file as {@link #requireWritable(Path)} does.
     *
     * @param option that names the file; null for a file that is not asked for
     */
    public static void requireWritableFile(String option, Path file) {
        if (file != null) {
            Path folder = file.toAbsolutePath().getParent();
            requireWritable(option, folder == null ? file : folder);
            if (Files.isDirectory(file)) {
                throw new BadInputException(option + " " + file + ": found a folder, expected a file");
            }
        }
    }

    /**
     * Checks a folder as {@link #requireWritable(Path)} does.
     *
     * @param option that names the folder, or a file in it
     */
    public static Path requireWritable(String option, Path folder) {
        if (folder.toString().isEmpty()) {
            throw new BadInputException(option + ": found an empty name, expected a folder");
        }
        Path nearest = ExistingPath.nearest(folder).orElse(null);
        if (nearest == null) {
            throw new BadInputException(option + " " + folder + ": found no drive "
                    + folder.toAbsolutePath().getRoot() + ", expected one that is there");
        }
        if (!Files.isDirectory(nearest)) {
            throw new BadInputException(option + " " + folder + ": found the file " + nearest + ", expected a folder");
        }
        if (!Files.isWritable(nearest)) {
            throw new BadInputException(option + " " + folder + ": found no permission to write into " + nearest
                    + ", expected a folder of yours");
        }
        return folder;
    }

    /**
     * Refuses to write over something that the command reads.
     *
     * @param option what names the place to write to, for the error message
     * @param written file or folder to write; null for none
     * @param read files or folders that are read; null for none
     * @throws BadInputException with one sentence, if both are the same
     */
    public static void requireNotRead(String option, Path written, Path... read) {
        for (Path input : read) {
            try {
                if (written != null
                        && input != null
                        && Files.exists(written)
                        && Files.exists(input)
                        && Files.isSameFile(input, written)) {
                    throw new BadInputException(option + " " + written + ": found "
                            + (Files.isDirectory(input) ? "a folder" : "a file")
                            + " that the command reads, expected another");
                }
            } catch (IOException e) {
                throw InputBytes.readFailure(input, e);
            }
        }
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
