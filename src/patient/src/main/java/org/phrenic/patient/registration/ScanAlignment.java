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
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * Brings a second scan of a body to the first by a rigid motion, found on what does not breathe: the spine where both
 * scans have it, else the apex of the lungs and their posterior medial surface, which lies on the spine and the necks
 * of the ribs. Trimmed iterative closest points, point to plane (Chen and Medioni 1992, doi
 * 10.1016/0262-8856(92)90066-C; Chetverikov, Stepanov and Krsek 2005, doi 10.1016/j.imavis.2004.05.007): each round
 * takes the points of the first scan's fixed part that lie nearest to the second's surface,
 * {@value TrimmedIcp#INLIER_FRACTION} of them, and turns and shifts so that their distances along its normals become
 * least.
 *
 * @param motion from the second scan's place to the first's
 * @param fixedPart what it was found on
 * @param residual distances of all points of the fixed part from the second scan's surface in its new place, by area,
 *     mm
 * @param inlierResidual the same of the points that were not trimmed
 */
public record ScanAlignment(
        RigidMotion motion, FixedPart fixedPart, DistanceSummary residual, DistanceSummary inlierResidual) {
    /** What an alignment rests on. */
    public enum FixedPart {
        /** Vertebrae that both scans have. */
        SPINE("the spine"),
        /** Apex and posterior medial surface of the lungs. */
        LUNGS("apex and posterior medial surface of the lungs");

        private final String label;

        FixedPart(String label) {
            this.label = label;
        }

        public String label() {
            return label;
        }
    }

    private static final int LEAST_VERTEBRAE = 2;
    /** The apex: this share of a lung's height from its top. */
    private static final double APEX = 0.12;
    /** The posterior medial surface ends above the base: at this share of the height from the top. */
    private static final double ABOVE_BASE = 0.65;
    /** It is the hindmost part of a lung's depth, and of its width the part nearest to the other lung. */
    private static final double POSTERIOR = 0.35;

    private static final double MEDIAL = 0.5;
    /** It looks backward or to the middle; the sum of both parts of its normal is above this. */
    private static final double LOOKS = 0.5;

    /**
     * Finds the motion.
     *
     * @param first the scan that stays
     * @param second the scan that is to be moved
     * @throws IllegalArgumentException if they share neither a spine nor a lung
     */
    public static ScanAlignment of(Thorax first, Thorax second) {
        List<TriangleMesh> from = new ArrayList<>();
        List<TriangleMesh> to = new ArrayList<>();
        for (Structure vertebra : first.structuresOf(StructureKind.VERTEBRA)) {
            second.find(vertebra.kind(), vertebra.level(), vertebra.side()).ifPresent(other -> {
                from.add(vertebra.mesh());
                to.add(other.mesh());
            });
        }
        if (from.size() >= LEAST_VERTEBRAE) {
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
            throw new IllegalArgumentException(
                    "found neither two vertebrae nor a lung that both scans have, expected what one can be brought to the other by");
        }
        TriangleMesh lungs = MeshMerge.merge(from);
        return new TrimmedIcp(lungs, fixed(from), MeshMerge.merge(to)).align(FixedPart.LUNGS, false);
    }

    /** Which vertices of lungs, one after the other, lie on apex or posterior medial surface. */
    private static boolean[] fixed(List<TriangleMesh> lungs) {
        double[] all = MeshMerge.merge(lungs).bounds();
        double middle = (all[0] + all[3]) / 2;
        List<Boolean> fixed = new ArrayList<>();
        for (TriangleMesh lung : lungs) {
            double[] box = lung.bounds();
            double[] normals = MeshMeasure.vertexNormals(lung);
            // Of a single lung nothing tells where the middle is: all of its back counts.
            double centre = (box[0] + box[3]) / 2;
            double toMiddle = lungs.size() == 1 ? 0 : Math.signum(middle - centre);
            for (int v = 0; v < lung.vertexCount(); v++) {
                double down = (box[5] - lung.z(v)) / (box[5] - box[2]);
                double back = (lung.y(v) - box[1]) / (box[4] - box[1]);
                double inward = 0.5 + toMiddle * (lung.x(v) - centre) / (box[3] - box[0]);
                double looks = normals[3 * v + 1] + toMiddle * normals[3 * v];
                boolean besideSpine = down < ABOVE_BASE
                        && back > 1 - POSTERIOR
                        && (toMiddle == 0 || inward > 1 - MEDIAL)
                        && looks > LOOKS;
                fixed.add(down < APEX || besideSpine);
            }
        }
        boolean[] array = new boolean[fixed.size()];
        for (int v = 0; v < array.length; v++) {
            array[v] = fixed.get(v);
        }
        return array;
    }

    /** The second scan's body where it belongs. */
    public Thorax apply(Thorax second) {
        return new Thorax(
                second.name(),
                second.structures().stream()
                        .map(s -> s.withMesh(moved(s.mesh())))
                        .toList(),
                second.notes());
    }

    private TriangleMesh moved(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        motion.apply(p);
        return mesh.withPositions(p);
    }

    /** Size of the turn, degrees. */
    public double rotationDeg() {
        double trace = motion.rotation(0, 0) + motion.rotation(1, 1) + motion.rotation(2, 2);
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, (trace - 1) / 2))));
    }
}
