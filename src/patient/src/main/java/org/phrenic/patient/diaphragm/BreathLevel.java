package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * The breath level at which a body was scanned, from the height of the domes against the spine. At end-expiration the
 * right dome stands at T8 and the left at T9; at full inspiration they stand at T11/T12 and T12 (physiology C2).
 *
 * @param right level of the right dome in vertebrae: 8.5 is half way from the middle of T8 to that of T9; NaN if the
 *     scan does not show the base of the right lung
 * @param left level of the left dome
 * @param descent mean descent of the domes from end-expiration, vertebrae
 * @param share that descent as a share of the descent to full inspiration, 0 at end-expiration
 * @param descentMm that descent, mm
 */
public record BreathLevel(double right, double left, double descent, double share, double descentMm) {
    /** Levels of the right and the left dome at end-expiration. */
    private static final double[] EXPIRED = {8, 9};
    /** Levels of the right and the left dome at full inspiration. */
    private static final double[] INSPIRED = {11.5, 12};
    /** Share from which a scan counts as one at inspiration: one vertebra, by which people differ. */
    private static final double CLEARLY_INSPIRED = 0.3;
    /** Least number of vertebrae and ribs in a scan whose level is judged. */
    private static final int LEAST_BONES = 6;
    /** Anterior share of the depth of a vertebra in which its body lies. */
    private static final double BODY_SHARE = 0.2;

    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 2;

    /**
     * Estimates the level of a completed body; empty if the scan shows too few bones or no base of a lung.
     *
     * @param body completed body, LPS, mm
     */
    public static Optional<BreathLevel> of(PatientBody body) {
        long bones = body.structures().stream()
                .filter(s ->
                        s.source() == PatientStructure.Source.SCAN || s.source() == PatientStructure.Source.EXTENDED)
                .map(s -> s.structure().kind())
                .filter(kind -> kind == StructureKind.VERTEBRA || kind == StructureKind.RIB)
                .count();
        List<double[]> spine = spine(body.thorax());
        if (bones < LEAST_BONES || spine.size() < 2) {
            return Optional.empty();
        }
        double[] level = {Double.NaN, Double.NaN};
        double descent = 0;
        double share = 0;
        double descentMm = 0;
        int sides = 0;
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            Optional<Double> top = top(body, side);
            if (top.isPresent()) {
                int i = side == Side.RIGHT ? 0 : 1;
                level[i] = levelAt(spine, top.get());
                descent += level[i] - EXPIRED[i];
                share += (level[i] - EXPIRED[i]) / (INSPIRED[i] - EXPIRED[i]);
                descentMm += heightOf(spine, EXPIRED[i]) - top.get();
                sides++;
            }
        }
        return sides == 0
                ? Optional.empty()
                : Optional.of(new BreathLevel(level[0], level[1], descent / sides, share / sides, descentMm / sides));
    }

    /** Whether the scan is one at inspiration beyond the differences between people. */
    public boolean isInspired() {
        return share >= CLEARLY_INSPIRED;
    }

    /** The levels of the domes, such as "T9.4 on the right and T10.7 on the left". */
    public String domes() {
        List<String> sides = new ArrayList<>();
        if (!Double.isNaN(right)) {
            sides.add(name(right) + " on the right");
        }
        if (!Double.isNaN(left)) {
            sides.add(name(left) + " on the left");
        }
        return String.join(" and ", sides);
    }

    private static String name(double level) {
        boolean lumbar = level >= StructureName.FIRST_LUMBAR;
        return String.format(
                Locale.ROOT, lumbar ? "L%.1f" : "T%.1f", lumbar ? level - StructureName.FIRST_LUMBAR + 1 : level);
    }

    /** Top of the base of a lung that the scan shows. */
    private static Optional<Double> top(PatientBody body, Side side) {
        List<PatientStructure> lobes = body.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.LUNG
                        && s.structure().side() == side)
                .toList();
        if (lobes.isEmpty() || !lobes.stream().allMatch(BreathLevel::showsBase)) {
            return Optional.empty();
        }
        Thorax lung = new Thorax(
                body.name(), lobes.stream().map(PatientStructure::structure).toList(), List.of());
        return LungBase.of(lung).stream().findFirst().map(LungBase::top);
    }

    private static boolean showsBase(PatientStructure lobe) {
        return lobe.scan()
                .map(scan -> !scan.cutAt().contains("I"))
                .orElse(lobe.source() == PatientStructure.Source.SCAN);
    }

    /** Level and height of each vertebral body, from top to bottom. */
    private static List<double[]> spine(Thorax body) {
        List<double[]> heights = new ArrayList<>();
        for (int level = 1; level <= LAST_LEVEL; level++) {
            int number = level;
            body.find(StructureKind.VERTEBRA, level, Side.MIDLINE)
                    .map(Structure::mesh)
                    .ifPresent(mesh -> heights.add(new double[] {number, bodyHeight(mesh)}));
        }
        return heights;
    }

    private static double bodyHeight(TriangleMesh vertebra) {
        double[] box = vertebra.bounds();
        double front = box[1] + BODY_SHARE * (box[4] - box[1]);
        double sum = 0;
        int count = 0;
        for (int v = 0; v < vertebra.vertexCount(); v++) {
            if (vertebra.y(v) <= front) {
                sum += vertebra.z(v);
                count++;
            }
        }
        return sum / count;
    }

    private static double levelAt(List<double[]> spine, double z) {
        int i = 1;
        while (i < spine.size() - 1 && spine.get(i)[1] > z) {
            i++;
        }
        double[] a = spine.get(i - 1);
        double[] b = spine.get(i);
        return a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]);
    }

    private static double heightOf(List<double[]> spine, double level) {
        int i = 1;
        while (i < spine.size() - 1 && spine.get(i)[0] < level) {
            i++;
        }
        double[] a = spine.get(i - 1);
        double[] b = spine.get(i);
        return a[1] + (b[1] - a[1]) * (level - a[0]) / (b[0] - a[0]);
    }
}
