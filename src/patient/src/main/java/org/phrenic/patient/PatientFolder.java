package org.phrenic.patient;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlWriter;
import org.phrenic.mesh.io.VtpWriter;

/** Writes a body as a thorax folder: a VTP file per structure, {@code import.json} and {@code thorax.yaml}. */
public final class PatientFolder {
    private PatientFolder() {}

    /**
     * Writes into a folder, each file as a whole or not at all; {@code thorax.yaml}, which lists the others, last.
     *
     * @param report content of {@code import.json}
     * @throws org.phrenic.file.OutputException if a file cannot be written
     */
    public static void write(Path folder, PatientBody body, Map<String, ?> report) {
        OrderedValues files = new OrderedValues();
        for (PatientStructure s : body.structures()) {
            String name = s.structure().name();
            VtpWriter.write(folder.resolve(name + ".vtp"), s.structure().mesh(), Map.of());
            files.put(name, name + ".vtp");
        }
        JsonWriter.write(folder.resolve("import.json"), report);
        YamlWriter.write(
                folder.resolve("thorax.yaml"),
                new OrderedValues()
                        .with("name", body.name())
                        .with("axes", "LPS")
                        .with("units", "mm")
                        .with("structures", files));
    }
}
