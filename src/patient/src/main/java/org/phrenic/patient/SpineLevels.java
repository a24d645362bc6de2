package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;

/**
 * Levels of the spine against heights: 8.5 is half way from the middle of the body of T8 to that of T9. Beyond the
 * first and the last vertebra the distance of the two nearest goes on.
 */
public final class SpineLevels {
    /** Anterior share of the depth of a vertebra in which its body lies. */
    private static final double BODY_SHARE = 0.2;

    /** Level and height of each vertebral body, mm, from top to bottom. */
    private final List<double[]> heights = new ArrayList<>();

    private SpineLevels() {}

    /**
     * Levels of a body whose axes are those of the patient.
     *
     * @param last last level that counts, such as 12 for T12 and 13 for L1
     */
    public static SpineLevels of(Thorax body, int last) {
        SpineLevels spine = new SpineLevels();
        for (int level = 1; level <= last; level++) {
            int number = level;
            body.find(StructureKind.VERTEBRA, level, Side.MIDLINE)
                    .map(Structure::mesh)
                    .ifPresent(mesh -> spine.heights.add(new double[] {number, bodyHeight(mesh)}));
        }
        return spine;
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

    /** Number of vertebrae; levels and heights take two. */
    public int count() {
        return heights.size();
    }

    /** Level at a height, mm. */
    public double levelAt(double z) {
        int i = 1;
        while (i < heights.size() - 1 && heights.get(i)[1] > z) {
            i++;
        }
        double[] a = heights.get(i - 1);
        double[] b = heights.get(i);
        return a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1]);
    }

    /** Height of a level, mm. */
    public double heightOf(double level) {
        int i = 1;
        while (i < heights.size() - 1 && heights.get(i)[0] < level) {
            i++;
        }
        double[] a = heights.get(i - 1);
        double[] b = heights.get(i);
        return a[1] + (b[1] - a[1]) * (level - a[0]) / (b[0] - a[0]);
    }

    /** Mean distance of two vertebrae that follow each other, mm. */
    public double spacingMm() {
        double[] first = heights.get(0);
        double[] last = heights.get(heights.size() - 1);
        return (first[1] - last[1]) / (last[0] - first[0]);
    }
}
