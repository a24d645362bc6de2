package org.phrenic.study.body;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/**
 * Finds the organ vertices on the wrong side of the diaphragm.
 *
 * <p>A vertex is on the side of the face (thoracic or abdominal) that holds its nearest point of the sheet; a vertex
 * between the two faces is on the wrong side. Its depth is the distance to the face of its own side. Beyond the border
 * of the sheet there are no sides: a vertex counts only if it is nearer to the sheet than its nearest point is to the
 * border, and if the segment to it from the middle of its organ passes the sheet an odd number of times.
 */
final class SheetCrossing {
    /**
     * Greatest sum of the distances from both faces of a point between them, relative to the thickness at rest. Where
     * the sheet folds through itself the sign of a distance says nothing of a point farther away.
     */
    private static final double THICKENED = 2;

    private record Faces(
            TriangleTree whole,
            SurfaceDistance distance,
            TriangleTree thoracic,
            TriangleTree abdominal,
            TriangleTree border) {}

    private final Diaphragm diaphragm;
    /** Triangles with corners on both faces. */
    private final boolean[] onBorder;

    /** Greatest sum of the distances from both faces of a point between them, mm. */
    private final double between;

    private final SegmentProbe probe = new SegmentProbe();

    SheetCrossing(Diaphragm diaphragm) {
        this.diaphragm = diaphragm;
        int[] t = diaphragm.sheet().triangles();
        onBorder = new boolean[t.length / 3];
        for (int i = 0; i < onBorder.length; i++) {
            boolean first = diaphragm.isThoracic(t[3 * i]);
            onBorder[i] = first != diaphragm.isThoracic(t[3 * i + 1]) || first != diaphragm.isThoracic(t[3 * i + 2]);
        }
        between = THICKENED * thickness();
    }

    /** The thickness of the sheet that 95 % of the vertices of its thoracic face do not exceed, mm. */
    private double thickness() {
        TriangleMesh sheet = diaphragm.sheet();
        TriangleTree abdominal = new TriangleTree(face(sheet, false));
        double[] thicknesses = IntStream.range(0, sheet.vertexCount())
                .filter(diaphragm::isThoracic)
                .mapToDouble(v -> distance(abdominal, sheet.x(v), sheet.y(v), sheet.z(v)))
                .toArray();
        return OrderStatistic.atShare(thicknesses, 0.95);
    }

    private static double distance(TriangleTree tree, double x, double y, double z) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        return tree.closest(x, y, z, hit) ? Math.sqrt(hit.distanceSquared) : Double.POSITIVE_INFINITY;
    }

    /**
     * Measures the organs of a scene.
     *
     * @param surfaces all surfaces of the scene
     * @param meshes their present positions
     */
    OrganCrossing measure(List<Surface> surfaces, List<TriangleMesh> meshes) {
        TriangleMesh sheet = meshes.get(indexOfDiaphragm(surfaces));
        Faces faces = new Faces(
                new TriangleTree(sheet),
                new SurfaceDistance(sheet),
                new TriangleTree(face(sheet, true)),
                new TriangleTree(face(sheet, false)),
                new TriangleTree(border(sheet)));
        int lungs = 0;
        int liver = 0;
        int others = 0;
        double deepest = 0;
        String where = "";
        for (int i = 0; i < surfaces.size(); i++) {
            Surface surface = surfaces.get(i);
            DiaphragmSide side = DiaphragmSide.of(surface.kind(), surface.name());
            if (side == DiaphragmSide.NEITHER) {
                continue;
            }
            double[] depths = depths(meshes.get(i).positions(), side == DiaphragmSide.ABOVE, faces);
            int through = (int) DoubleStream.of(depths)
                    .filter(depth -> depth > BodyLimits.THROUGH_MM)
                    .count();
            double most = DoubleStream.of(depths).max().orElse(0);
            where = most > deepest ? surface.name() : where;
            deepest = Math.max(deepest, most);
            switch (surface.kind()) {
                case LUNG -> lungs += through;
                case LIVER -> liver += through;
                default -> others += through;
            }
        }
        return new OrganCrossing(lungs, liver, others, deepest, where);
    }

    private static int indexOfDiaphragm(List<Surface> surfaces) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> surfaces.get(i).kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow();
    }

    /** The triangles of one face, without those on the border. */
    private TriangleMesh face(TriangleMesh whole, boolean thoracic) {
        int[] t = whole.triangles();
        int[] kept = new int[t.length];
        int n = 0;
        for (int i = 0; i < onBorder.length; i++) {
            if (!onBorder[i] && diaphragm.isThoracic(t[3 * i]) == thoracic) {
                System.arraycopy(t, 3 * i, kept, n, 3);
                n += 3;
            }
        }
        return new TriangleMesh(whole.positions(), Arrays.copyOf(kept, n));
    }

    private TriangleMesh border(TriangleMesh whole) {
        return new TriangleMesh(
                whole.positions(),
                IntStream.range(0, whole.triangles().length)
                        .filter(corner -> onBorder[corner / 3])
                        .map(corner -> whole.triangles()[corner])
                        .toArray());
    }

    /** Depth of each point on the wrong side of the sheet, mm; 0 on its own side and beyond the border. */
    private double[] depths(double[] points, boolean above, Faces faces) {
        double[] signed = faces.distance.isSigned() ? faces.distance.signedDistance(points) : null;
        int[] corners = diaphragm.sheet().triangles();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        TriangleTree.Hit working = new TriangleTree.Hit();
        TriangleTree own = above ? faces.thoracic : faces.abdominal;
        double[] middle = mean(points);
        double[] depths = new double[points.length / 3];
        for (int i = 0; i < depths.length; i++) {
            int k = 3 * i;
            faces.whole.closest(points[k], points[k + 1], points[k + 2], hit);
            int t = hit.triangle;
            boolean inside = signed != null && signed[i] < 0 && isBetween(points, k, faces);
            boolean ownSide = t < 0
                    || isBeyondBorder(hit, faces.border, working)
                    || (!inside && diaphragm.isThoracic(corners[3 * t]) == above);
            if (!ownSide
                    && (inside || isBehind(points, k, middle, faces.whole))
                    && own.closest(points[k], points[k + 1], points[k + 2], hit)) {
                depths[i] = Math.sqrt(hit.distanceSquared);
            }
        }
        return depths;
    }

    private boolean isBetween(double[] points, int k, Faces faces) {
        return distance(faces.thoracic, points[k], points[k + 1], points[k + 2])
                        + distance(faces.abdominal, points[k], points[k + 1], points[k + 2])
                < between;
    }

    /** Whether a point is beyond the border: farther from its nearest point of the sheet than the border is. */
    private boolean isBeyondBorder(TriangleTree.Hit hit, TriangleTree border, TriangleTree.Hit working) {
        return border.isWithin(hit.x, hit.y, hit.z, Math.sqrt(hit.distanceSquared), working);
    }

    /** Whether the segment from the middle of the organ to a point passes the sheet an odd number of times. */
    private boolean isBehind(double[] points, int k, double[] middle, TriangleTree sheet) {
        probe.set(middle[0], middle[1], middle[2], points[k], points[k + 1], points[k + 2]);
        int crossings = probe.intersect(sheet);
        int passes = 0;
        for (int i = 0; i < crossings; i++) {
            passes += probe.facing(i) < 0 ? 1 : 0;
        }
        return passes % 2 == 1;
    }

    private static double[] mean(double[] points) {
        double[] mean = new double[3];
        for (int i = 0; i < points.length; i++) {
            mean[i % 3] += 3 * points[i] / points.length;
        }
        return mean;
    }
}
