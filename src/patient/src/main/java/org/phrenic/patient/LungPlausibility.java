package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * Checks that lungs have plausible human size and shape, and that organs of the abdomen lie on the sides where people
 * have them. If not, spacing, axes or labels of the file may be wrong.
 */
final class LungPlausibility {
    /** Organs of the abdomen and the side on which nearly all people have them. */
    private static final Map<String, Side> ORGANS = Map.of("liver", Side.RIGHT, "spleen", Side.LEFT);

    /** Maximum ratio of left to right lung volume. The left lung is usually smaller because of the heart. */
    private static final double MAX_LEFT = 1.1;
    /** Range of the height to depth ratio of the bounding box of both lungs, from virtual bodies and scans. */
    private static final double MIN_HEIGHT = 1.1;

    private static final double MAX_HEIGHT = 1.8;
    /** Volume range of a lung, ml: from a child at end-expiration to a tall man at total lung capacity. */
    private static final double MIN_ML = 150;

    private static final double MAX_ML = 5000;

    private LungPlausibility() {}

    /** Returns one sentence for each implausible finding. */
    static List<String> check(List<PatientStructure> structures) {
        List<String> findings = new ArrayList<>();
        List<PatientStructure> lungs = structures.stream()
                .filter(s -> s.structure().kind() == StructureKind.LUNG)
                .toList();
        Optional<TriangleMesh> right = lung(lungs, Side.RIGHT);
        Optional<TriangleMesh> left = lung(lungs, Side.LEFT);
        boolean complete = lungs.stream().allMatch(PatientStructure::isComplete);
        if (right.isPresent() && left.isPresent()) {
            Map<String, Boolean> organs = organs(structures, right.get(), left.get());
            compare(right.get(), left.get(), complete && organs.isEmpty(), findings);
            if (!organs.isEmpty() && !organs.containsValue(true)) {
                findings.add(String.join(" and ", organs.keySet()) + " on the other side than in most people: situs"
                        + " inversus, or right and left are exchanged in labels of lungs and bones, or the volume"
                        + " states its axes wrongly (mirrored), see --axes");
            }
        }
        if (complete) {
            right.ifPresent(mesh -> size("right", mesh, findings));
            left.ifPresent(mesh -> size("left", mesh, findings));
            MedianFrame frame = MedianFrame.of(new Thorax(
                    "scan", structures.stream().map(PatientStructure::structure).toList(), List.of()));
            PatientBody.merged(lungs.stream().map(PatientStructure::structure))
                    .ifPresent(mesh -> proportions(frame.toFrame(mesh), findings));
        }
        return findings;
    }

    private static Optional<TriangleMesh> lung(List<PatientStructure> lungs, Side side) {
        return PatientBody.merged(
                lungs.stream().map(PatientStructure::structure).filter(s -> s.side() == side));
    }

    /** Whether each organ of the abdomen lies on its usual side of the plane midway between the lungs. */
    private static Map<String, Boolean> organs(
            List<PatientStructure> structures, TriangleMesh right, TriangleMesh left) {
        double[] r = MeshMeasure.centreOfMass(right);
        double[] l = MeshMeasure.centreOfMass(left);
        double[] middle = {(r[0] + l[0]) / 2, (r[1] + l[1]) / 2, (r[2] + l[2]) / 2};
        double[] toLeft = Vectors.subtract(l, r);
        Map<String, Boolean> organs = new TreeMap<>();
        structures.stream()
                .map(PatientStructure::structure)
                .filter(s -> ORGANS.containsKey(s.name()))
                .forEach(s -> {
                    double[] from = Vectors.subtract(MeshMeasure.centreOfMass(s.mesh()), middle);
                    Side side = Vectors.dot(from, toLeft) > 0 ? Side.LEFT : Side.RIGHT;
                    organs.put(s.name(), side == ORGANS.get(s.name()));
                });
        return organs;
    }

    /**
     * Volumes are compared where both lungs are complete and no organ tells the sides: some people have the larger lung
     * on the left.
     */
    private static void compare(TriangleMesh right, TriangleMesh left, boolean volumes, List<String> findings) {
        double[] r = right.bounds();
        double[] l = left.bounds();
        double rightMl = MeshMeasure.signedVolumeMl(right);
        double leftMl = MeshMeasure.signedVolumeMl(left);
        // The x axis points to the patient's left.
        if (r[0] + r[3] > l[0] + l[3]) {
            findings.add("the right lung lies on the left of the left one: labels are exchanged, or the volume states"
                    + " its axes wrongly (mirrored), see --axes");
        } else if (volumes && leftMl > MAX_LEFT * rightMl) {
            findings.add(Numbers.format(
                    "the left lung is larger than the right (%.0f and %.0f ml): the volume may state its axes wrongly"
                            + " (turned or mirrored), see --axes",
                    leftMl, rightMl));
        }
    }

    private static void size(String side, TriangleMesh lung, List<String> findings) {
        double ml = MeshMeasure.signedVolumeMl(lung);
        if (ml < MIN_ML || ml > MAX_ML) {
            findings.add(Numbers.format(
                    "the %s lung holds %.3g ml: people's hold %.0f to %.0f ml; is the spacing right? see --spacing",
                    side, ml, MIN_ML, MAX_ML));
        }
    }

    /** @param lungs both lungs in the frame of the body's median plane */
    private static void proportions(TriangleMesh lungs, List<String> findings) {
        double[] box = lungs.bounds();
        double height = box[5] - box[2];
        double depth = box[4] - box[1];
        if (height < MIN_HEIGHT * depth || height > MAX_HEIGHT * depth) {
            findings.add(Numbers.format(
                    "lungs %.0f mm tall and %.0f mm deep: people's are %.1f to %.1f times as tall as deep;"
                            + " is the spacing right? see --spacing, or --axes",
                    height, depth, MIN_HEIGHT, MAX_HEIGHT));
        }
    }
}
