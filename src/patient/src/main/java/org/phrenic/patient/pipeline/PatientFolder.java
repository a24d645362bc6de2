package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** Writes a body as a thorax folder with one VTP file per structure, {@code import.json} and {@code thorax.yaml}. */
final class PatientFolder {
    private PatientFolder() {}

    /**
     * Writes a body to a folder. Each file is written completely or not at all. While they are written,
     * {@code thorax.yaml} says so, and the folder is read as no body; it is written last because it lists the other
     * files. No mesh that this import replaces lies beside the new {@code import.json}, which states how the meshes
     * beside it were aligned.
     *
     * @param statements what else than structures the scan does not show, in words
     * @param report content of {@code import.json}
     * @throws org.phrenic.file.OutputException if a file cannot be written
     */
    static void write(Path folder, PatientBody body, List<String> statements, Map<String, ?> report) {
        Path indexFile = folder.resolve(ThoraxFolder.INDEX_FILE);
        YamlWriter.write(indexFile, Map.of(ThoraxFolder.UNFINISHED_KEY, true));
        OrderedValues files = new OrderedValues();
        for (PatientStructure s : body.structures()) {
            AtomicFile.delete(mesh(folder, s));
            files.put(s.structure().name(), mesh(folder, s).getFileName().toString());
        }
        JsonWriter.write(folder.resolve("import.json"), report);
        for (PatientStructure s : body.structures()) {
            VtpWriter.write(mesh(folder, s), s.structure().mesh(), Map.of());
        }
        OrderedValues index = new OrderedValues()
                .with("name", body.name())
                .with("axes", "LPS")
                .with("units", "mm")
                .with("structures", files);
        List<String> notInScan = Stream.concat(body.notInScan().stream(), statements.stream())
                .distinct()
                .toList();
        YamlWriter.write(indexFile, notInScan.isEmpty() ? index : index.with("not_in_scan", notInScan));
    }

    private static Path mesh(Path folder, PatientStructure structure) {
        return folder.resolve(structure.structure().name() + ".vtp");
    }
}
