package org.phrenic.study.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TrunkSkin;
import org.phrenic.access.path.AccessMap;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/**
 * The free ways of an access map, tried against every triangle of every avoided surface at every moment: no tree, no
 * change of axes, and signs of volumes in place of the map's arithmetic.
 *
 * @param ways ways that the map calls free, counted at every moment
 * @param crossing number of them that pass through any of these surfaces
 * @param crossed number of them that pass through a surface, by its name
 * @param entries points of the skin from which the map calls a way free at some moment
 * @param atCutEnd number of those that lie on a flat end of the body
 */
public record WayCheck(int ways, int crossing, Map<String, Integer> crossed, int entries, int atCutEnd) {
    /** Triangles of the skin this near to its upper or lower end, and this flat, are a cut end. */
    private static final double END_MM = 2;

    private static final double END_NORMAL = 0.9;

    /**
     * Tries all ways that are free at some moment, at the moments at which they are free.
     *
     * @param surfaces of the scene of the map
     */
    static WayCheck of(List<Surface> surfaces, AccessMap map) {
        int[] free = IntStream.range(0, map.size())
                .filter(v -> map.access(v) != AccessMap.Access.NEVER)
                .toArray();
        Map<String, Integer> crossed = new TreeMap<>();
        int ways = 0;
        int crossing = 0;
        for (int m = 0; m < map.cycle().size(); m++) {
            int moment = m;
            List<double[]> paths = new ArrayList<>();
            double[] to = map.target(m);
            double[] skin = positions(surfaces, skinOf(surfaces), map.cycle().get(m));
            IntStream.of(free)
                    .filter(v -> map.isFree(moment, v))
                    .forEach(v -> paths.add(
                            new double[] {skin[3 * v], skin[3 * v + 1], skin[3 * v + 2], to[0], to[1], to[2]}));
            ways += paths.size();
            boolean[] any = new boolean[paths.size()];
            for (int i = 0; i < surfaces.size(); i++) {
                Surface s = surfaces.get(i);
                if (NoGoZone.of(s.kind()).filter(map.avoided()::contains).isPresent()) {
                    double[] p = positions(surfaces, i, map.cycle().get(m));
                    int[] t = s.rest().triangles();
                    int[] through = IntStream.range(0, any.length)
                            .parallel()
                            .filter(w -> isCrossed(paths.get(w), p, t))
                            .toArray();
                    IntStream.of(through).forEach(w -> any[w] = true);
                    if (through.length > 0) {
                        crossed.merge(s.name(), through.length, Integer::sum);
                    }
                }
            }
            crossing += (int) IntStream.range(0, any.length).filter(w -> any[w]).count();
        }
        boolean[] end = cutEnd(surfaces.get(skinOf(surfaces)).rest());
        int atEnd = (int) IntStream.of(free).filter(v -> end[v]).count();
        return new WayCheck(ways, crossing, crossed, free.length, atEnd);
    }

    private static int skinOf(List<Surface> surfaces) {
        return surfaces.indexOf(TrunkSkin.of(surfaces).orElseThrow());
    }

    private static double[] positions(List<Surface> surfaces, int index, BreathMoment moment) {
        Surface s = surfaces.get(index);
        double[] p = new double[s.rest().positions().length];
        moment.frame().writePositions(s, index, p);
        return p;
    }

    private static boolean isCrossed(double[] path, double[] p, int[] triangles) {
        for (int t = 0; t < triangles.length; t += 3) {
            if (isCrossed(path, p, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2])) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a segment passes through a triangle or its border: its ends lie on two sides of the plane, or one of them
     * in it, and its line passes all edges in one sense. A segment in the plane passes through none.
     *
     * @param path start and end, six numbers
     * @param a index of the first coordinate of a corner in {@code p}
     */
    static boolean isCrossed(double[] path, double[] p, int a, int b, int c) {
        double from = volume(path, 0, p, a, b, c);
        double to = volume(path, 3, p, a, b, c);
        if (from * to > 0 || (from == 0 && to == 0)) {
            return false;
        }
        double ab = edge(path, p, a, b);
        double bc = edge(path, p, b, c);
        double ca = edge(path, p, c, a);
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    }

    /** Six times the volume between a triangle and one end of a path. */
    private static double volume(double[] path, int end, double[] p, int a, int b, int c) {
        return determinant(
                p[a] - path[end],
                p[a + 1] - path[end + 1],
                p[a + 2] - path[end + 2],
                p[b] - path[end],
                p[b + 1] - path[end + 1],
                p[b + 2] - path[end + 2],
                p[c] - path[end],
                p[c + 1] - path[end + 1],
                p[c + 2] - path[end + 2]);
    }

    /** Six times the volume between a path and an edge: its sign is the sense in which the path passes the edge. */
    private static double edge(double[] path, double[] p, int a, int b) {
        return determinant(
                path[3] - path[0],
                path[4] - path[1],
                path[5] - path[2],
                p[a] - path[0],
                p[a + 1] - path[1],
                p[a + 2] - path[2],
                p[b] - path[0],
                p[b + 1] - path[1],
                p[b + 2] - path[2]);
    }

    private static double determinant(
            double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz) {
        return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }

    /** Vertices of a skin that belong to a flat triangle at its upper or lower end. */
    static boolean[] cutEnd(TriangleMesh skin) {
        double[] box = skin.bounds();
        double[] normals = MeshMeasure.triangleNormals(skin);
        boolean[] end = new boolean[skin.vertexCount()];
        int[] t = skin.triangles();
        for (int i = 0; i < t.length; i += 3) {
            double low = Math.min(skin.z(t[i]), Math.min(skin.z(t[i + 1]), skin.z(t[i + 2])));
            double high = Math.max(skin.z(t[i]), Math.max(skin.z(t[i + 1]), skin.z(t[i + 2])));
            double up = normals[i + 2];
            if ((up < -END_NORMAL && high < box[2] + END_MM) || (up > END_NORMAL && low > box[5] - END_MM)) {
                end[t[i]] = true;
                end[t[i + 1]] = true;
                end[t[i + 2]] = true;
            }
        }
        return end;
    }

    /** Whether no way crosses anything and no entry lies on a cut end. */
    public boolean passes() {
        return crossed.isEmpty() && atCutEnd == 0;
    }
}
