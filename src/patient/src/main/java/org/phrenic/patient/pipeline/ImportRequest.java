package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.patient.label.GeometryOverride;

/**
 * What an import is asked for.
 *
 * @param file the label volume
 * @param name name of the body
 * @param labels label table: a CSV file, the name of a tool or data set such as {@code totalsegmentator}, or
 *     {@code lungs} for a mask of both lungs; empty guesses
 * @param edgeMm edge length of the triangles, mm; empty uses a length by structure (see
 *     {@link org.phrenic.patient.ScanImport})
 * @param geometry axes and spacing of the volume where the file states them wrongly; without axes those of the file are
 *     judged by the places of the structures
 * @param completion how the body is completed; empty leaves it as scanned
 * @param alignTo body of an earlier scan of the same patient; the new scan is brought to it rigidly and not completed
 */
public record ImportRequest(
        Path file,
        String name,
        Optional<String> labels,
        Optional<Double> edgeMm,
        GeometryOverride geometry,
        Optional<Completion> completion,
        Optional<Thorax> alignTo) {
    /**
     * How a body is completed.
     *
     * @param template thorax from which structures come that the scan lacks
     * @param keepLevel leave a scan at inspiration as it is; otherwise it is brought to end-expiration
     */
    public record Completion(Thorax template, boolean keepLevel) {}

    /** A request with default edges that completes the body with a template. */
    public static ImportRequest of(Path file, String name, Optional<String> labels, Thorax template) {
        return new ImportRequest(
                file,
                name,
                labels,
                Optional.empty(),
                GeometryOverride.NONE,
                Optional.of(new Completion(template, false)),
                Optional.empty());
    }
}
