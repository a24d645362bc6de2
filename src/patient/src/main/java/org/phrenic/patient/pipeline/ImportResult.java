package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.diaphragm.UnknownSides;
import org.phrenic.patient.registration.ScanAlignment;

/**
 * An imported body.
 *
 * @param file name of the volume or folder, for messages and reports
 * @param grid voxel grid of the volume; empty for a folder of meshes
 * @param alignment how a second scan was brought to the body of a first one; empty if it was not
 * @param quality quality of the diaphragm; empty if the body has none, or no cage that it could be measured against
 * @param resting the completed body and its breath level; empty if it was not completed
 * @param statements what else than structures its scan does not show, in words
 */
public record ImportResult(
        String file,
        Optional<LabelGrid> grid,
        PatientBody body,
        Optional<ScanAlignment> alignment,
        Optional<SheetQuality> quality,
        Optional<RestingBody> resting,
        List<String> statements) {
    public ImportResult {
        statements = List.copyOf(statements);
    }

    /** Measures the diaphragm of the body; adds notes on limits and on unknown structures that it passes through. */
    static ImportResult of(String file, Optional<LabelGrid> grid, PatientBody body, Optional<ScanAlignment> alignment) {
        Optional<SheetQuality> quality = SheetQuality.of(body.thorax());
        return new ImportResult(
                file,
                grid,
                body.withNotes(Stream.concat(
                                quality.flatMap(SheetQuality::warning).stream(),
                                UnknownSides.note(body.thorax()).stream())
                        .toList()),
                alignment,
                quality,
                Optional.empty(),
                List.of());
    }

    /** The result for a completed body. */
    static ImportResult of(String file, Optional<LabelGrid> grid, RestingBody resting) {
        ImportResult plain = of(file, grid, resting.body(), Optional.empty());
        return new ImportResult(
                file,
                grid,
                plain.body(),
                Optional.empty(),
                plain.quality(),
                Optional.of(resting),
                resting.statements());
    }

    /** Returns a copy that states what the imported folder does, before its own statements. */
    ImportResult withStatements(List<String> ofFolder) {
        List<String> all =
                Stream.concat(ofFolder.stream(), statements.stream()).distinct().toList();
        return new ImportResult(file, grid, body, alignment, quality, resting, all);
    }

    /** Returns a copy whose body has a further note. */
    public ImportResult withNote(String note) {
        return new ImportResult(file, grid, body.withNotes(List.of(note)), alignment, quality, resting, statements);
    }

    /** The content of {@code import.json}. */
    public Map<String, Object> report() {
        return ImportReport.of(this).with("notice", Disclaimer.TEXT);
    }

    /**
     * Writes the body to a thorax folder.
     *
     * @throws org.phrenic.file.OutputException if a file cannot be written
     */
    public void write(Path folder) {
        PatientFolder.write(folder, body, statements, report());
    }
}
