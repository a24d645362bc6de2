package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * What an import is asked for.
 *
 * @param file the label volume
 * @param name name of the body
 * @param labels label table: a CSV file, {@code totalsegmentator}, or {@code lungs} for a mask of both lungs; empty
 *     guesses
 * @param edgeMm edge length of the triangles, mm; empty uses a length by structure (see
 *     {@link org.phrenic.patient.ScanImport})
 * @param geometry correction of the volume's axes and spacing; the identity where the file states them correctly
 * @param completion how the body is completed; empty leaves it as scanned
 * @param alignTo body of an earlier scan of the same patient; the new scan is brought to it rigidly and not completed
 */
public record ImportRequest(
        Path file,
        String name,
        Optional<String> labels,
        Optional<Double> edgeMm,
        UnaryOperator<LabelVolume> geometry,
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
                UnaryOperator.identity(),
                Optional.of(new Completion(template, false)),
                Optional.empty());
    }
}
