package org.phrenic.cli.option;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.file.AtomicFile;
import picocli.CommandLine.Option;

/** The option for the folder of the reports. Without it, nothing is written. */
public final class ReportFolder {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path folder;

    /** Checks, before any computation, that the folder is writable; see {@link OutputFolder#requireWritable}. */
    public void check() {
        if (folder != null) {
            OutputFolder.requireWritable(folder);
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
