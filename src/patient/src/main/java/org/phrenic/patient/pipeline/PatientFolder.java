package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlWriter;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** Writes a body as a thorax folder with one VTP file per structure, {@code import.json} and {@code thorax.yaml}. */
final class PatientFolder {
    private PatientFolder() {}

    /**
     * Writes a body to a folder. Each file is written completely or not at all. {@code thorax.yaml} is written last
     * because it lists the other files.
     *
     * @param statements what else than structures the scan does not show, in words
     * @param report content of {@code import.json}
     * @throws org.phrenic.file.OutputException if a file cannot be written
     */
    static void write(Path folder, PatientBody body, List<String> statements, Map<String, ?> report) {
        OrderedValues files = new OrderedValues();
        for (PatientStructure s : body.structures()) {
            String name = s.structure().name();
            VtpWriter.write(folder.resolve(name + ".vtp"), s.structure().mesh(), Map.of());
            files.put(name, name + ".vtp");
        }
        JsonWriter.write(folder.resolve("import.json"), report);
        OrderedValues index = new OrderedValues()
                .with("name", body.name())
                .with("axes", "LPS")
                .with("units", "mm")
                .with("structures", files);
        List<String> notInScan = new ArrayList<>(body.notInScan());
        notInScan.addAll(statements);
        YamlWriter.write(
                folder.resolve("thorax.yaml"), notInScan.isEmpty() ? index : index.with("not_in_scan", notInScan));
    }
}
