package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;

/**
 * What does not look like the lungs of people, and what of the file may be the reason: sizes of voxels, axes, or
 * labels.
 */
final class LungPlausibility {
    /** The heart takes room from the left lung. */
    private static final double LARGER_LEFT = 1.1;
    /** Height over depth from front to back, of both lungs in a box: the virtual bodies' and those of scans. */
    private static final double LEAST_TALL = 1.1;

    private static final double MOST_TALL = 1.8;
    /** From a child's lung at end-expiration to one of a tall man who has breathed in all he can. */
    private static final double LEAST_ML = 150;

    private static final double MOST_ML = 5000;
    private static final double MM3_PER_ML = 1000;

    private LungPlausibility() {}

    /** One sentence each. */
    static List<String> check(List<PatientStructure> organs) {
        List<String> remarks = new ArrayList<>();
        List<PatientStructure> lungs = organs.stream()
                .filter(o -> o.structure().kind() == StructureKind.LUNG)
                .toList();
        Optional<TriangleMesh> right = lung(lungs, Side.RIGHT);
        Optional<TriangleMesh> left = lung(lungs, Side.LEFT);
        if (right.isPresent() && left.isPresent()) {
            compare(right.get(), left.get(), remarks);
        }
        if (!lungs.isEmpty()
                && lungs.stream()
                        .allMatch(o ->
                                o.scan().map(PatientStructure.Scan::isComplete).orElse(true))) {
            right.ifPresent(mesh -> size("right", mesh, remarks));
            left.ifPresent(mesh -> size("left", mesh, remarks));
            proportions(
                    MeshMerge.merge(
                            lungs.stream().map(o -> o.structure().mesh()).toList()),
                    remarks);
        }
        return remarks;
    }

    private static Optional<TriangleMesh> lung(List<PatientStructure> lungs, Side side) {
        List<TriangleMesh> lobes = lungs.stream()
                .filter(o -> o.structure().side() == side)
                .map(o -> o.structure().mesh())
                .toList();
        return lobes.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(lobes));
    }

    private static void compare(TriangleMesh right, TriangleMesh left, List<String> remarks) {
        double[] r = right.bounds();
        double[] l = left.bounds();
        // x runs to the patient's left.
        if (r[0] + r[3] > l[0] + l[3]) {
            remarks.add(
                    "the right lung lies on the left of the left one: labels are exchanged, or the volume states its axes wrongly (mirrored), see --axes");
            return;
        }
        double rightMl = MeshMeasure.signedVolume(right) / MM3_PER_ML;
        double leftMl = MeshMeasure.signedVolume(left) / MM3_PER_ML;
        if (leftMl > LARGER_LEFT * rightMl) {
            remarks.add(String.format(
                    Locale.ROOT,
                    "the left lung is larger than the right (%.0f and %.0f ml): the volume may state its axes wrongly (turned or mirrored), see --axes",
                    leftMl,
                    rightMl));
        }
    }

    private static void size(String side, TriangleMesh lung, List<String> remarks) {
        double ml = MeshMeasure.signedVolume(lung) / MM3_PER_ML;
        if (ml < LEAST_ML || ml > MOST_ML) {
            remarks.add(String.format(
                    Locale.ROOT,
                    "the %s lung holds %.3g ml: people's hold %.0f to %.0f ml; is the spacing right? see --spacing",
                    side,
                    ml,
                    LEAST_ML,
                    MOST_ML));
        }
    }

    private static void proportions(TriangleMesh lungs, List<String> remarks) {
        double[] box = lungs.bounds();
        double tall = box[5] - box[2];
        double deep = box[4] - box[1];
        if (tall < LEAST_TALL * deep || tall > MOST_TALL * deep) {
            remarks.add(String.format(
                    Locale.ROOT,
                    "lungs %.0f mm tall and %.0f mm deep: people's are %.1f to %.1f times as tall as deep; is the spacing right? see --spacing, or --axes",
                    tall,
                    deep,
                    LEAST_TALL,
                    MOST_TALL));
        }
    }
}
