package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.PatientBody;

/**
 * An imported body.
 *
 * @param file name of the volume, for messages and reports
 * @param grid voxel grid of the volume
 */
public record ImportResult(String file, LabelGrid grid, PatientBody body) {
    /** The content of {@code import.json}. */
    public Map<String, Object> report() {
        return ImportReport.of(file, grid, body).with("notice", Disclaimer.TEXT);
    }

    /**
     * Writes the body to a thorax folder.
     *
     * @throws org.phrenic.file.OutputException if a file cannot be written
     */
    public void write(Path folder) {
        PatientFolder.write(folder, body, report());
    }
}
