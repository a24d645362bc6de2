package org.phrenic.patient.diaphragm;

import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * A body that was brought from inspiration to end-expiration.
 *
 * @param domesMm rise of the domes, mm: less than their descent where that is more than domes may rise
 */
public record RaisedBody(PatientBody body, double domesMm) {
    /** Least part of the descent left over that a note states, mm. */
    private static final double STATED_MM = 1;

    /**
     * The body with a note that states the amounts.
     *
     * @param scanned the same body at inspiration
     * @param backMm rise of the highest part of the domes, mm
     * @param share share of a full inspiration by which the ribs have turned back
     */
    RaisedBody withNote(PatientBody scanned, BreathLevel level, double backMm, double share) {
        double left = level.descentMm() - domesMm;
        double before = lungMl(scanned) / 1000;
        String lungs = before == 0
                ? ""
                : Numbers.format(", the lungs deflated from %.1f to %.1f l", before, lungMl(body) / 1000);
        String note = Numbers.format(
                "the scan is one at inspiration, %s: the domes are raised by %.0f mm, up to %.0f mm at the back, with"
                        + " the organs about them%s, the ribs turned back by %.0f %% of a full inspiration",
                level.stated(), domesMm, backMm, lungs, 100 * share);
        String rest = left < STATED_MM
                ? ""
                : Numbers.format(
                        "; the domes stay %.0f mm below end-expiration, for domes as low or flat as these rise no more",
                        left);
        return new RaisedBody(body.withNotes(List.of(note + rest)), domesMm);
    }

    private static double lungMl(PatientBody body) {
        return body.structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() == StructureKind.LUNG)
                .mapToDouble(s -> MeshMeasure.signedVolumeMl(s.mesh()))
                .sum();
    }
}
