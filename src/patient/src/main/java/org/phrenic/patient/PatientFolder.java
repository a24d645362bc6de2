package org.phrenic.patient;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.mesh.io.VtpWriter;

/**
 * Writes a body as a thorax folder: a VTP file a structure, {@code thorax.yaml} and {@code import.json}, which says
 * where each came from.
 */
public final class PatientFolder {
    private PatientFolder() {}

    /**
     * Writes into a folder, each file whole or not at all; {@code thorax.yaml} last, and only what it lists counts.
     *
     * @param report what {@code import.json} holds
     * @throws org.phrenic.format.OutputException if a file cannot be written
     */
    public static void write(Path folder, PatientBody body, Map<String, ?> report) {
        Map<String, Object> structures = new LinkedHashMap<>();
        for (PatientStructure organ : body.structures()) {
            String name = organ.structure().name();
            VtpWriter.write(folder.resolve(name + ".vtp"), organ.structure().mesh(), Map.of());
            structures.put(name, name + ".vtp");
        }
        JsonWriter.write(folder.resolve("import.json"), report);
        Map<String, Object> index = new LinkedHashMap<>();
        index.put("name", body.name());
        index.put("axes", "LPS");
        index.put("units", "mm");
        index.put("structures", structures);
        YamlWriter.write(folder.resolve("thorax.yaml"), index);
    }
}
