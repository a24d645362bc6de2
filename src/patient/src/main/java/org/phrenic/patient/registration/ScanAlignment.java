package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.patient.PatientBody;

/**
 * Rigid alignment of a second scan of a body to the first. It uses parts that do not move with the breath: the spine if
 * both scans contain it, otherwise the apex and the posterior medial surface of the lungs, which lies against the spine
 * and the necks of the ribs. The method is trimmed iterative closest points with point to plane distances
 * ({@link TrimmedIcp}).
 *
 * @param motion rigid motion from the axes of the second scan to those of the first
 * @param fixedPart part used for the alignment
 * @param residual area-weighted distances from all points of the fixed part to the aligned second scan, mm
 * @param inlierResidual area-weighted distances of the points that were not trimmed, mm
 */
public record ScanAlignment(
        RigidMotion motion, FixedPart fixedPart, DistanceSummary residual, DistanceSummary inlierResidual) {
    /** Part of the body used for an alignment. */
    public enum FixedPart {
        /** Vertebrae contained in both scans. */
        SPINE("the spine"),
        /** Apex and posterior medial surface of the lungs. */
        LUNGS("apex and posterior medial surface of the lungs");

        private final String label;

        FixedPart(String label) {
            this.label = label;
        }

        /** Display name. */
        public String label() {
            return label;
        }
    }

    /** A second scan in the axes of a first one, and how it came there. */
    public record Aligned(PatientBody body, ScanAlignment alignment) {}

    private static final int MIN_VERTEBRAE = 2;
    /** The apex is this upper fraction of the height of a lung. */
    private static final double APEX = 0.12;
    /** Lower end of the posterior medial surface, as a fraction of the height from the top. */
    private static final double ABOVE_BASE = 0.65;
    /** Posterior fraction of the depth and medial fraction of the width of a lung. */
    private static final double POSTERIOR = 0.35;

    private static final double MEDIAL = 0.5;
    /** Minimum sum of the posterior and medial components of the normal on the posterior medial surface. */
    private static final double MIN_NORMAL = 0.5;

    /**
     * Aligns two scans by structures that both of them show.
     *
     * @throws IllegalArgumentException if the scans share neither a spine nor a lung
     */
    public static ScanAlignment of(Thorax first, Thorax second) {
        return ofShown(shown(first), shown(second));
    }

    /** The body without what its scan does not show, which comes from a template. */
    private static Thorax shown(Thorax body) {
        List<Structure> shown =
                body.structures().stream().filter(body::isInScan).toList();
        return new Thorax(body.name(), shown, body.notes());
    }

    private static ScanAlignment ofShown(Thorax first, Thorax second) {
        List<TriangleMesh> from = new ArrayList<>();
        List<TriangleMesh> to = new ArrayList<>();
        for (Structure vertebra : first.structuresOf(StructureKind.VERTEBRA)) {
            second.find(vertebra.kind(), vertebra.level(), vertebra.side()).ifPresent(other -> {
                from.add(vertebra.mesh());
                to.add(other.mesh());
            });
        }
        if (from.size() >= MIN_VERTEBRAE) {
            TriangleMesh spine = MeshMerge.merge(from);
            boolean[] all = new boolean[spine.vertexCount()];
            Arrays.fill(all, true);
            return new TrimmedIcp(spine, all, MeshMerge.merge(to)).align(FixedPart.SPINE, true);
        }
        from.clear();
        to.clear();
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            Optional<TriangleMesh> a = LungDistances.lung(first, side);
            Optional<TriangleMesh> b = LungDistances.lung(second, side);
            if (a.isPresent() && b.isPresent()) {
                from.add(a.get());
                to.add(b.get());
            }
        }
        if (from.isEmpty()) {
            throw new IllegalArgumentException("found neither two vertebrae nor a lung that both scans have,"
                    + " expected what one can be brought to the other by");
        }
        TriangleMesh lungs = MeshMerge.merge(from);
        return new TrimmedIcp(lungs, fixed(from, lungs), MeshMerge.merge(to)).align(FixedPart.LUNGS, false);
    }

    /** Marks the vertices on the apex or the posterior medial surface, one lung after the other. */
    private static boolean[] fixed(List<TriangleMesh> lungs, TriangleMesh merged) {
        double[] all = merged.bounds();
        double middle = (all[0] + all[3]) / 2;
        boolean[] fixed = new boolean[merged.vertexCount()];
        int next = 0;
        for (TriangleMesh lung : lungs) {
            double[] box = lung.bounds();
            double[] normals = MeshMeasure.vertexNormals(lung);
            // A single lung does not determine the midline, so its entire posterior surface is used.
            double centre = (box[0] + box[3]) / 2;
            double toMiddle = lungs.size() == 1 ? 0 : Math.signum(middle - centre);
            for (int v = 0; v < lung.vertexCount(); v++) {
                double down = (box[5] - lung.z(v)) / (box[5] - box[2]);
                double back = (lung.y(v) - box[1]) / (box[4] - box[1]);
                double inward = 0.5 + toMiddle * (lung.x(v) - centre) / (box[3] - box[0]);
                double facing = normals[3 * v + 1] + toMiddle * normals[3 * v];
                boolean besideSpine = down < ABOVE_BASE
                        && back > 1 - POSTERIOR
                        && (toMiddle == 0 || inward > 1 - MEDIAL)
                        && facing > MIN_NORMAL;
                fixed[next++] = down < APEX || besideSpine;
            }
        }
        return fixed;
    }

    /**
     * Returns the body of a second scan in the axes of the first, with notes on the alignment and on the lung
     * distances.
     *
     * @throws IllegalArgumentException if the scans share neither a spine nor a lung
     */
    public static Aligned aligned(Thorax first, PatientBody second) {
        Thorax ofFirst = shown(first);
        ScanAlignment alignment = ofShown(ofFirst, shown(second.thorax()));
        PointTransform motion = alignment.motion::apply;
        PatientBody body = second.withEach(motion::apply);
        List<String> notes = new ArrayList<>(List.of(alignment.sentence(first.name())));
        LungDistances.between(ofFirst, body.thorax())
                .forEach((side, d) -> notes.add("lungs, " + side + ", off " + first.name() + ": whole "
                        + text(d.whole()) + ", base " + text(d.base())));
        return new Aligned(body.withNotes(notes), alignment);
    }

    /** How a scan was brought to a body. */
    public String sentence(String body) {
        return Numbers.format(
                "brought rigidly to %s by %s, turned by %.2f deg: of its %d points the nearer 70 %% lie %.2f mm apart"
                        + " (rms), all %.2f mm (median %.2f)",
                body,
                fixedPart.label,
                rotationDeg(),
                residual.points(),
                inlierResidual.rms(),
                residual.rms(),
                residual.median());
    }

    private static String text(DistanceSummary d) {
        return Numbers.format(
                "%.2f +- %.2f mm (rms %.2f, 95 %% %.1f)", d.mean(), d.deviation(), d.rms(), d.percentile95());
    }

    /** Rotation angle, degrees. */
    public double rotationDeg() {
        double trace = motion.rotation(0, 0) + motion.rotation(1, 1) + motion.rotation(2, 2);
        return Math.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, (trace - 1) / 2))));
    }
}
