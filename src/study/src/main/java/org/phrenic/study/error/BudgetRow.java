package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.document.CsvWriter;

/**
 * One measurement of the error budget. A quantity that a part does not measure is NaN.
 *
 * @param part part of the budget
 * @param body name of the body
 * @param breath breathing preset
 * @param mesh label of the resolution, or the number of vertices of the diaphragm
 * @param setting solver setting, phase or step that was measured
 * @param usual whether it is a default of the program
 * @param edgeMm mean edge length of the diaphragm, mm
 * @param excursionMm largest descent of the domes with the setting, mean of both sides, mm
 * @param rmsMm rms distance of the diaphragm's nodes from what the part compares with, mm
 * @param maxMm maximum distance, mm
 * @param uncertaintyMm rms uncertainty of what the part compares with, mm
 * @param cpuS processor time, s
 * @param realTime simulated time over processor time on one thread
 */
public record BudgetRow(
        BudgetPart part,
        String body,
        String breath,
        String mesh,
        String setting,
        boolean usual,
        double edgeMm,
        double excursionMm,
        double rmsMm,
        double maxMm,
        double uncertaintyMm,
        double cpuS,
        double realTime) {
    /** End of the setting of rows that hold a breath against Newton's equilibrium. */
    static final String NEWTON = ", Newton";

    private static final int DIGITS = 5;
    private static final double EQUILATERAL = 2 / Math.sqrt(3);

    static final List<String> HEADER = List.of(("part body breath mesh setting usual edge_mm excursion_mm rms_mm max_mm"
                    + " uncertainty_mm cpu_s real_time")
            .split(" "));

    /** Mean edge length of a mesh of near-equilateral triangles, mm: with n vertices an area of n √3/2 edge². */
    static double edgeMm(double areaMm2, int vertices) {
        return Math.sqrt(EQUILATERAL * areaMm2 / vertices);
    }

    /** Whether both rows measure the same. */
    boolean replaces(BudgetRow other) {
        return isOf(other.part, other.body, other.breath, other.mesh) && setting.equals(other.setting);
    }

    /** Whether the row is of a part of the budget of a scene. */
    boolean isOf(BudgetPart wanted, String onBody, String ofBreath, String onMesh) {
        return part == wanted && body.equals(onBody) && breath.equals(ofBreath) && mesh.equals(onMesh);
    }

    /** Whether the row holds a breath against Newton's equilibrium instead of the one that the held body takes. */
    boolean isOfNewton() {
        return setting.endsWith(NEWTON);
    }

    /** Distance in per cent of the excursion. */
    double percent() {
        return 100 * rmsMm / excursionMm;
    }

    List<Object> cells() {
        List<Object> cells = new ArrayList<>(List.of(part.label(), body, breath, mesh, setting, usual));
        double[] numbers = {edgeMm, excursionMm, rmsMm, maxMm, uncertaintyMm, cpuS, realTime};
        Arrays.stream(numbers).forEach(n -> cells.add(CsvWriter.number(n, DIGITS)));
        return cells;
    }
}
