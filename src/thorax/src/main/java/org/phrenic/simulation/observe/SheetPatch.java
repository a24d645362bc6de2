package org.phrenic.simulation.observe;

import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.organ.DiaphragmPart;

/**
 * A small patch on the thoracic face of the diaphragm, whose mean displacement represents a region: the posterior dome,
 * as in M-mode ultrasound, the front or the side. Positions are plan-view coordinates in the body's frame, normalised
 * by half the width and half the depth of the sheet.
 */
public final class SheetPatch {
    /** Radius at which a vertex no longer counts, mm: as broad as a disc of 15 mm, by the root mean square distance. */
    private static final double RADIUS_MM = 21;

    private static final double ROOF = 0.3;

    /** Axes of the body's frame, three numbers each. */
    private final double[] axes;

    private final int[] nodes;
    /** Share of each node in the mean. */
    private final double[] weights;

    /**
     * @param part the diaphragm in its scene
     * @param u position to the left, -1 to 1
     * @param v position to the back, -1 to 1
     */
    public SheetPatch(DiaphragmPart part, double u, double v) {
        Diaphragm d = part.diaphragm;
        axes = d.frame().axes();
        TriangleMesh sheet = d.upright();
        double[] box = sheet.bounds();
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double x = 0.5 * (box[0] + box[3]) + u * 0.5 * (box[3] - box[0]);
        double y = 0.5 * (box[1] + box[4]) + v * 0.5 * (box[4] - box[1]);
        int[] roof = IntStream.range(0, sheet.vertexCount())
                .filter(i -> d.isThoracic(i) && !d.isInserted(i) && normals[3 * i + 2] > ROOF)
                .toArray();
        int[] near = IntStream.of(roof)
                .filter(i -> StrictMath.hypot(sheet.x(i) - x, sheet.y(i) - y) < RADIUS_MM)
                .toArray();
        if (near.length == 0) {
            near = IntStream.of(roof)
                    .boxed()
                    .min((a, b) -> Double.compare(
                            StrictMath.hypot(sheet.x(a) - x, sheet.y(a) - y),
                            StrictMath.hypot(sheet.x(b) - x, sheet.y(b) - y)))
                    .map(i -> new int[] {i})
                    .orElse(new int[0]);
        }
        nodes = IntStream.of(near).map(i -> part.firstNode + i).toArray();
        weights = weights(sheet, normals, near, x, y);
    }

    /** Shares that fall smoothly to 0 at the border, by the area that each vertex stands for in the plan view. */
    private static double[] weights(TriangleMesh sheet, double[] normals, int[] vertices, double x, double y) {
        if (vertices.length == 1) {
            return new double[] {1};
        }
        double[] areas = MeshMeasure.vertexAreas(sheet);
        double[] weights = new double[vertices.length];
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            int v = vertices[i];
            double distance = StrictMath.hypot(sheet.x(v) - x, sheet.y(v) - y) / RADIUS_MM;
            double inside = 1 - distance * distance;
            weights[i] = areas[v] * normals[3 * v + 2] * inside * inside;
            sum += weights[i];
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    /** Mean displacement along an axis of the body's frame (0 left, 1 posterior, 2 superior), mm. */
    public double displacement(double[] rest, double[] now, int axis) {
        double sum = 0;
        for (int i = 0; i < nodes.length; i++) {
            int at = 3 * nodes[i];
            sum += weights[i]
                    * MedianFrame.along(
                            axes, axis, now[at] - rest[at], now[at + 1] - rest[at + 1], now[at + 2] - rest[at + 2]);
        }
        return sum;
    }
}
