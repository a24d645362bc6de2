package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.geometry.DistanceSummary;
import org.phrenic.geometry.TriangleMesh;

/** A second scan of a patient, brought to the body that was made of the first: what a fit takes as its target. */
public final class SecondScan {
    private SecondScan() {}

    /**
     * The second scan's organs where they belong, with notes on how they were brought there and how far the lungs then lie from the first scan's.
     *
     * @throws IllegalArgumentException if the two share nothing that stands still
     */
    public static FittedBody alignedTo(Thorax first, FittedBody second) {
        ScanAlignment alignment = ScanAlignment.of(first, second.thorax());
        List<Organ> organs = new ArrayList<>();
        for (Organ organ : second.organs()) {
            Structure s = organ.structure();
            double[] p = s.mesh().positions().clone();
            alignment.motion().apply(p);
            TriangleMesh moved = s.mesh().withPositions(p);
            organs.add(new Organ(s.withMesh(moved), organ.source(), organ.scan(), organ.offScan()));
        }
        List<String> notes = new ArrayList<>(second.notes());
        DistanceSummary kept = alignment.kept();
        DistanceSummary all = alignment.residual();
        notes.add(String.format(
                Locale.ROOT,
                "brought rigidly to %s by %s, turned by %.2f deg: of its %d points the nearer 70 %% lie %.2f mm apart (rms), all %.2f mm (median %.2f)",
                first.name(),
                alignment.fixedPart().label(),
                alignment.turnDeg(),
                all.points(),
                kept.rms(),
                all.rms(),
                all.median()));
        FittedBody body = new FittedBody(second.name(), organs, second.missing(), notes);
        LungDistances.between(first, body.thorax())
                .forEach((side, d) -> notes.add("lungs, " + side + ", off " + first.name() + ": whole "
                        + text(d.whole()) + ", base " + text(d.base())));
        return new FittedBody(body.name(), organs, body.missing(), notes);
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
