package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;

/**
 * Elliptic sections of the parts of the trunk that have no structures of their own: the neck above the first thoracic
 * vertebra and, in a body without bowel or skin there, the abdomen below the middle of the lower ribs: as broad and
 * deep as the lower rib cage at the costal margin and at the lower end, narrower at the waist between them.
 *
 * @param z height, mm
 * @param a half the breadth, mm
 * @param b half the depth, mm
 */
record TrunkSection(double z, double x, double y, double a, double b) {
    /** Spacing of the sections along the body, mm. */
    private static final double STEP_MM = 4;
    /** Breadth and depth of the abdomen relative to those of the lower rib cage, at the waist. */
    private static final double WAIST = 0.9;
    /** The same of what fills the lower half of the rib cage, inside the ribs. */
    private static final double INSIDE = 0.85;
    /** Length of the abdomen below the twelfth thoracic vertebra where no structure reaches lower, mm. */
    private static final double ABDOMEN_MM = 200;
    /** How far below the costal margin bowel or skin reaches that fills the abdomen, mm. */
    private static final double BELOW_CAGE_MM = 50;
    /** Half the breadth and depth of the neck without skin and muscle, and its height above T1, mm. */
    private static final double NECK_A_MM = 45;

    private static final double NECK_B_MM = 40;
    private static final double NECK_MM = 50;
    private static final int T12 = StructureName.FIRST_LUMBAR - 1;

    /** Sections of a body, from below; empty if it has no ribs or thoracic vertebrae. */
    static List<TrunkSection> of(List<Structure> body) {
        List<TrunkSection> all = new ArrayList<>();
        abdomen(body, all);
        PatientBody.bounds(body.stream().filter(s -> s.kind() == StructureKind.VERTEBRA && s.level() == 1))
                .ifPresent(t1 -> {
                    double x = (t1[0] + t1[3]) / 2;
                    double y = t1[1] + NECK_B_MM / 2;
                    for (double z = t1[2]; z < t1[5] + NECK_MM; z += STEP_MM) {
                        all.add(new TrunkSection(z, x, y, NECK_A_MM, NECK_B_MM));
                    }
                });
        return all;
    }

    private static void abdomen(List<Structure> body, List<TrunkSection> all) {
        Optional<double[]> cage = PatientBody.bounds(body.stream()
                .filter(s -> s.kind() == StructureKind.RIB || s.kind() == StructureKind.COSTAL_CARTILAGE)
                .filter(s -> s.level() >= 7 && s.level() <= 10));
        Optional<double[]> t12 =
                PatientBody.bounds(body.stream().filter(s -> s.kind() == StructureKind.VERTEBRA && s.level() == T12));
        if (cage.isEmpty() || t12.isEmpty()) {
            return;
        }
        double[] c = cage.get();
        boolean filled = body.stream()
                .filter(s -> s.kind() == StructureKind.SKIN || OrganNames.BOWEL.contains(s.name()))
                .anyMatch(s -> s.mesh().bounds()[2] < c[2] - BELOW_CAGE_MM);
        if (filled) {
            return;
        }
        double lowest = body.stream()
                .filter(s -> s.kind() != StructureKind.SKIN)
                .mapToDouble(s -> s.mesh().bounds()[2])
                .min()
                .orElseThrow();
        double bottom = Math.min(lowest, t12.get()[2] - ABDOMEN_MM);
        double margin = c[2] + 2 * STEP_MM;
        for (double z = bottom; z < 0.5 * (c[2] + c[5]); z += STEP_MM) {
            double down = Math.max(0, (margin - z) / (margin - bottom));
            double share = z < margin ? 1 - (1 - WAIST) * StrictMath.sin(Math.PI * down) : INSIDE;
            all.add(new TrunkSection(
                    z, (c[0] + c[3]) / 2, (c[1] + c[4]) / 2, share * (c[3] - c[0]) / 2, share * (c[4] - c[1]) / 2));
        }
    }
}
