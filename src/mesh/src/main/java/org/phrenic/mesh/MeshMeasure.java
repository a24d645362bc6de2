package org.phrenic.mesh;

import java.util.Arrays;
import org.phrenic.engine.math.Triangles;

/** Measures of a {@link TriangleMesh}: area, volume, normals, triangle quality, edge lengths. */
public final class MeshMeasure {
    /** Cubic millimetres in a millilitre. */
    public static final double MM3_PER_ML = 1000;

    /** Openness of a surface from which it has no inside. */
    private static final double MAX_OPENNESS = 0.2;

    private MeshMeasure() {}

    /** Statistics of edge lengths, mm. All zero without edges. */
    public record EdgeLengths(double minimum, double mean, double maximum) {}

    /** Total area, mm^2. */
    public static double area(TriangleMesh mesh) {
        double[] normal = new double[3];
        double sum = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            sum += 0.5 * triangleCrossProduct(mesh, t, normal);
        }
        return sum;
    }

    /**
     * Signed volume, mm^3, by the divergence theorem: the sum over triangles of p0 . (p1 x p2) / 6. It is positive if
     * triangles face outward. Positions are relative to the centre of the bounding box, which preserves precision far
     * from the origin.
     */
    public static double signedVolume(TriangleMesh mesh) {
        double[] centre = mesh.centre();
        double sum = 0;
        int[] triangles = mesh.triangles();
        for (int t = 0; t < triangles.length; t += 3) {
            sum += sixfoldVolume(mesh, triangles[t], triangles[t + 1], triangles[t + 2], centre);
        }
        return sum / 6;
    }

    /** Signed volume, ml. */
    public static double signedVolumeMl(TriangleMesh mesh) {
        return signedVolume(mesh) / MM3_PER_ML;
    }

    /** Centre of mass of a closed surface's inside: the mean of the tetrahedra to its triangles, by signed volume. */
    public static double[] centreOfMass(TriangleMesh mesh) {
        double[] centre = mesh.centre();
        double[] sum = new double[3];
        double volume = 0;
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        for (int i = 0; i < t.length; i += 3) {
            double sixfold = sixfoldVolume(mesh, t[i], t[i + 1], t[i + 2], centre);
            volume += sixfold;
            for (int axis = 0; axis < 3; axis++) {
                double corners = p[3 * t[i] + axis] + p[3 * t[i + 1] + axis] + p[3 * t[i + 2] + axis];
                sum[axis] += sixfold * (corners - 3 * centre[axis]) / 4;
            }
        }
        return new double[] {centre[0] + sum[0] / volume, centre[1] + sum[1] / volume, centre[2] + sum[2] / volume};
    }

    /**
     * Length of the sum of the triangles' area vectors relative to their area: 0 for a closed surface, the area of the
     * cut end for an organ that the border of a scan cuts, 0.5 for a hemisphere, 1 for a flat or empty one.
     */
    public static double openness(TriangleMesh mesh) {
        double[] normal = new double[3];
        double[] sum = new double[3];
        double area = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            area += triangleCrossProduct(mesh, t, normal);
            for (int axis = 0; axis < 3; axis++) {
                sum[axis] += normal[axis];
            }
        }
        return area > 0 ? Vectors.length(sum) / area : 1;
    }

    /** Whether a surface, which may have holes, encloses a space: whether it is at most a fifth open. */
    public static boolean hasInside(TriangleMesh mesh) {
        return openness(mesh) <= MAX_OPENNESS;
    }

    /** A third of the area of the triangles at each vertex, mm^2; sums to {@link #area}. */
    public static double[] vertexAreas(TriangleMesh mesh) {
        double[] areas = new double[mesh.vertexCount()];
        double[] normal = new double[3];
        int[] triangles = mesh.triangles();
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double third = triangleCrossProduct(mesh, t, normal) / 6;
            for (int k = 3 * t; k < 3 * t + 3; k++) {
                areas[triangles[k]] += third;
            }
        }
        return areas;
    }

    /** Unit normal of each triangle, x y z in turn; zero for a degenerate triangle. */
    public static double[] triangleNormals(TriangleMesh mesh) {
        double[] normals = new double[3 * mesh.triangleCount()];
        double[] normal = new double[3];
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double length = triangleCrossProduct(mesh, t, normal);
            if (length > 0) {
                for (int k = 0; k < 3; k++) {
                    normals[3 * t + k] = normal[k] / length;
                }
            }
        }
        return normals;
    }

    /**
     * Unit normal of each vertex, x y z in turn; zero for a vertex without triangles. It is the mean of the triangle
     * normals weighted by the angle at the vertex, which does not depend on the triangulation (Thuermer and Wuethrich
     * 1998, doi 10.1080/10867651.1998.10487487).
     */
    public static double[] vertexNormals(TriangleMesh mesh) {
        double[] normals = new double[3 * mesh.vertexCount()];
        double[] normal = new double[3];
        int[] triangles = mesh.triangles();
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double length = triangleCrossProduct(mesh, t, normal);
            if (length == 0) {
                continue;
            }
            for (int side = 3 * t; side < 3 * t + 3; side++) {
                double weight = cornerAngle(mesh, side) / length;
                int v = triangles[side];
                for (int k = 0; k < 3; k++) {
                    normals[3 * v + k] += weight * normal[k];
                }
            }
        }
        for (int i = 0; i < normals.length; i += 3) {
            double length = Math.sqrt(
                    normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2]);
            if (length > 0) {
                normals[i] /= length;
                normals[i + 1] /= length;
                normals[i + 2] /= length;
            }
        }
        return normals;
    }

    /** Smallest angle of each triangle, degrees; 60 if equilateral, 0 if degenerate. */
    public static double[] smallestAngles(TriangleMesh mesh) {
        double[] angles = new double[mesh.triangleCount()];
        double[] normal = new double[3];
        for (int t = 0; t < angles.length; t++) {
            if (triangleCrossProduct(mesh, t, normal) == 0) {
                continue;
            }
            double smallest = Math.min(
                    cornerAngle(mesh, 3 * t), Math.min(cornerAngle(mesh, 3 * t + 1), cornerAngle(mesh, 3 * t + 2)));
            angles[t] = Math.toDegrees(smallest);
        }
        return angles;
    }

    /** Length of each edge of {@code topology}, in its order, at the positions of {@code mesh}, mm. */
    public static double[] edgeLengths(TriangleMesh mesh, MeshTopology topology) {
        int[] edges = topology.edges();
        double[] lengths = new double[topology.edgeCount()];
        Arrays.setAll(lengths, e -> distance(mesh, edges[2 * e], edges[2 * e + 1]));
        return lengths;
    }

    public static EdgeLengths edgeLengthSummary(TriangleMesh mesh, MeshTopology topology) {
        double[] lengths = edgeLengths(mesh, topology);
        if (lengths.length == 0) {
            return new EdgeLengths(0, 0, 0);
        }
        double minimum = Double.POSITIVE_INFINITY;
        double maximum = 0;
        double sum = 0;
        for (double length : lengths) {
            minimum = Math.min(minimum, length);
            maximum = Math.max(maximum, length);
            sum += length;
        }
        return new EdgeLengths(minimum, sum / lengths.length, maximum);
    }

    /** Writes (p1 - p0) x (p2 - p0) to {@code out} and returns its length, twice the triangle area. */
    public static double triangleCrossProduct(TriangleMesh mesh, int triangle, double[] out) {
        double[] p = mesh.positions();
        int a = 3 * mesh.triangles()[3 * triangle];
        int b = 3 * mesh.triangles()[3 * triangle + 1];
        int c = 3 * mesh.triangles()[3 * triangle + 2];
        return Triangles.cross(p, a, b, c, out);
    }

    public static double distance(TriangleMesh mesh, int a, int b) {
        return Math.sqrt(Vectors.squaredDistance(mesh.positions(), a, b));
    }

    /** Centroid of a triangle, mm. */
    public static double[] centroid(TriangleMesh mesh, int triangle) {
        double[] mean = new double[3];
        for (int corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
            int v = mesh.triangles()[corner];
            mean[0] += mesh.x(v) / 3;
            mean[1] += mesh.y(v) / 3;
            mean[2] += mesh.z(v) / 3;
        }
        return mean;
    }

    /** Angle at the start corner of {@code side}, radians; atan2 is accurate near 0 and 180 degrees. */
    private static double cornerAngle(TriangleMesh mesh, int side) {
        double[] p = mesh.positions();
        int[] triangles = mesh.triangles();
        int a = 3 * triangles[side];
        int b = 3 * triangles[EdgeTable.next(side, 3)];
        int c = 3 * triangles[EdgeTable.next(EdgeTable.next(side, 3), 3)];
        double[] cross = new double[3];
        double sine = Triangles.cross(p, a, b, c, cross);
        double cosine = (p[b] - p[a]) * (p[c] - p[a])
                + (p[b + 1] - p[a + 1]) * (p[c + 1] - p[a + 1])
                + (p[b + 2] - p[a + 2]) * (p[c + 2] - p[a + 2]);
        return StrictMath.atan2(sine, cosine);
    }

    private static double sixfoldVolume(TriangleMesh mesh, int a, int b, int c, double[] centre) {
        double ax = mesh.x(a) - centre[0];
        double ay = mesh.y(a) - centre[1];
        double az = mesh.z(a) - centre[2];
        double bx = mesh.x(b) - centre[0];
        double by = mesh.y(b) - centre[1];
        double bz = mesh.z(b) - centre[2];
        double cx = mesh.x(c) - centre[0];
        double cy = mesh.y(c) - centre[1];
        double cz = mesh.z(c) - centre[2];
        return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }
}
