package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** A second scan of a patient, brought to the body that was made of the first: what a fit takes as its target. */
public final class SecondScan {
    private SecondScan() {}

    /**
     * The second scan's organs where they belong, with notes on how they were brought there and how far the lungs then
     * lie from the first scan's.
     *
     * @throws IllegalArgumentException if the two share nothing that stands still
     */
    public static PatientBody alignedTo(Thorax first, PatientBody second) {
        ScanAlignment alignment = ScanAlignment.of(first, second.thorax());
        List<PatientStructure> organs = new ArrayList<>();
        for (PatientStructure organ : second.structures()) {
            Structure s = organ.structure();
            double[] p = s.mesh().positions().clone();
            alignment.motion().apply(p);
            TriangleMesh moved = s.mesh().withPositions(p);
            organs.add(new PatientStructure(s.withMesh(moved), organ.source(), organ.scan(), organ.distanceToScan()));
        }
        List<String> notes = new ArrayList<>(second.notes());
        DistanceSummary kept = alignment.inlierResidual();
        DistanceSummary all = alignment.residual();
        notes.add(String.format(
                Locale.ROOT,
                "brought rigidly to %s by %s, turned by %.2f deg: of its %d points the nearer 70 %% lie %.2f mm apart (rms), all %.2f mm (median %.2f)",
                first.name(),
                alignment.fixedPart().label(),
                alignment.rotationDeg(),
                all.points(),
                kept.rms(),
                all.rms(),
                all.median()));
        PatientBody body = new PatientBody(second.name(), organs, second.missing(), notes);
        LungDistances.between(first, body.thorax())
                .forEach((side, d) -> notes.add("lungs, " + side + ", off " + first.name() + ": whole "
                        + text(d.whole()) + ", base " + text(d.base())));
        return new PatientBody(body.name(), organs, body.missing(), notes);
    }

    private static String text(DistanceSummary d) {
        return String.format(
                Locale.ROOT,
                "%.2f +- %.2f mm (rms %.2f, 95 %% %.1f)",
                d.mean(),
                d.deviation(),
                d.rms(),
                d.percentile95());
    }
}
