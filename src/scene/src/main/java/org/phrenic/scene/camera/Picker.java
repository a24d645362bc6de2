package org.phrenic.scene.camera;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.MovingLeastSquares;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Ray picking on the CPU. For a rigid surface, the ray is transformed to the rest pose and intersected through a
 * bounding volume tree. For a deforming surface, every triangle is tested (Moeller and Trumbore 1997, doi
 * 10.1080/10867651.1997.10487468), which costs less than refitting a tree. A nearly transparent surface is picked only
 * if the ray hits no surface of higher opacity. What a clip plane removes is not hit. Where the ray enters closed
 * bodies through the plane, the one that it leaves first is hit on its cut face.
 */
public final class Picker {
    /** Surfaces with a lower opacity are picked only if no other surface is hit. */
    public static final double MIN_SOLID_OPACITY = 0.6;

    private final List<Surface> surfaces;
    private final TriangleTree[] trees;
    /** Whether the triangles of a surface face outward, by its index; empty if it is open. */
    private final Map<Integer, Optional<Boolean>> outward = new HashMap<>();

    public Picker(List<Surface> surfaces) {
        this.surfaces = List.copyOf(surfaces);
        trees = this.surfaces.stream()
                .map(s -> s.motion() == Surface.Motion.DEFORMING ? null : new TriangleTree(s.rest()))
                .toArray(TriangleTree[]::new);
    }

    /**
     * The first intersection of a ray with a surface.
     *
     * @param alongNormal whether the ray goes the way of the triangle's normal
     */
    private record Crossing(int surface, int triangle, double distance, double[] weights, boolean alongNormal) {}

    /** The part of a ray that is not cut away, and the nearest hit so far. */
    private static final class Search {
        private final Vector3d origin;
        private final Vector3d direction;
        /** Of the nearest hit, before that of the end of the ray. */
        private double distance = Double.POSITIVE_INFINITY;

        private Crossing crossing;
        private boolean entersThroughPlane;
        private boolean isOnCutFace;

        Search(double[] ray, Optional<ClipPlane> clip) {
            origin = new Vector3d(ray[0], ray[1], ray[2]);
            direction = new Vector3d(ray[3], ray[4], ray[5]);
            clip.ifPresent(this::cut);
        }

        private void cut(ClipPlane plane) {
            double beyond = plane.nx() * origin.x + plane.ny() * origin.y + plane.nz() * origin.z - plane.offsetMm();
            double slope = plane.nx() * direction.x + plane.ny() * direction.y + plane.nz() * direction.z;
            if (slope > 0) {
                distance = -beyond / slope;
            } else if (beyond > 0 && slope < 0) {
                origin.fma(-beyond / slope, direction);
                entersThroughPlane = true;
            } else if (beyond > 0) {
                distance = Double.NEGATIVE_INFINITY;
            }
        }

        /** @param cut whether the ray enters the body of the surface through the plane: before any other hit */
        void offer(Crossing next, boolean cut) {
            if (cut == isOnCutFace ? next.distance < distance : cut) {
                crossing = next;
                distance = next.distance;
                isOnCutFace = cut;
            }
        }
    }

    /**
     * Finds the first hit of a ray.
     *
     * @param frame current positions and poses of the surfaces
     * @param ray origin and direction, as returned by {@link Camera#ray}
     * @param clip plane that cuts surfaces away
     * @param opacity opacity of a surface; 0 if hidden
     */
    public Optional<PickResult> pick(
            Frame frame, double[] ray, Optional<ClipPlane> clip, ToDoubleFunction<Surface> opacity) {
        return nearest(frame, new Search(ray, clip), opacity, MIN_SOLID_OPACITY)
                .or(() -> nearest(frame, new Search(ray, clip), opacity, Double.MIN_VALUE));
    }

    private Optional<PickResult> nearest(
            Frame frame, Search search, ToDoubleFunction<Surface> opacity, double minOpacity) {
        for (int i = 0; i < trees.length; i++) {
            double shown = opacity.applyAsDouble(surfaces.get(i));
            if (shown >= minOpacity) {
                Optional<Crossing> crossing = trees[i] == null
                        ? intersectTriangles(i, frame.positions(i), search)
                        : intersectTree(i, frame.pose(i), search);
                // Translucent bodies have no cut face.
                boolean capped = shown == 1 && search.entersThroughPlane;
                crossing.ifPresent(c -> search.offer(c, capped && leaves(c)));
            }
        }
        return search.crossing == null ? Optional.empty() : Optional.of(result(search, frame));
    }

    private PickResult result(Search search, Frame frame) {
        Crossing hit = search.crossing;
        Surface surface = surfaces.get(hit.surface);
        double[] sight = numbers(search.direction);
        if (search.isOnCutFace) {
            return onCutFace(hit.surface, numbers(search.origin), sight, frame);
        }
        TriangleMesh mesh = surface.rest();
        Vector3d at = new Vector3d(search.origin).fma(search.distance, search.direction);
        Vector3d rest = new Vector3d();
        int nearest = 0;
        for (int k = 0; k < 3; k++) {
            int v = mesh.triangles()[3 * hit.triangle + k];
            rest.fma(hit.weights[k], new Vector3d(mesh.x(v), mesh.y(v), mesh.z(v)));
            nearest = hit.weights[k] > hit.weights[nearest] ? k : nearest;
        }
        int vertex = mesh.triangles()[3 * hit.triangle + nearest];
        return new PickResult(hit.surface, surface, numbers(at), vertex, numbers(rest), sight, false);
    }

    private PickResult onCutFace(int index, double[] at, double[] sight, Frame frame) {
        Surface surface = surfaces.get(index);
        double[] now = new double[surface.rest().positions().length];
        frame.writePositions(surface, index, now);
        double[] rest = MovingLeastSquares.position(
                MovingLeastSquares.coefficients(now, at), surface.rest().positions());
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int v = 0; v < now.length; v += 3) {
            double square = Vector3d.distanceSquared(at[0], at[1], at[2], now[v], now[v + 1], now[v + 2]);
            nearest = square < least ? v / 3 : nearest;
            least = Math.min(square, least);
        }
        return new PickResult(index, surface, at, nearest, rest, sight, true);
    }

    /** Whether a ray leaves the body of a surface, which is closed, through a triangle. */
    private boolean leaves(Crossing crossing) {
        Optional<Boolean> faces = outward.computeIfAbsent(crossing.surface, this::facesOutward);
        return faces.isPresent() && faces.get() == crossing.alongNormal;
    }

    private Optional<Boolean> facesOutward(int surface) {
        TriangleMesh mesh = surfaces.get(surface).rest();
        return new EdgeTable(mesh).isClosed() ? Optional.of(MeshMeasure.signedVolume(mesh) > 0) : Optional.empty();
    }

    private static double[] numbers(Vector3d v) {
        return new double[] {v.x, v.y, v.z};
    }

    private Optional<Crossing> intersectTree(int surface, float[] pose, Search search) {
        Vector3d o = search.origin;
        Vector3d d = search.direction;
        if (pose.length > 0) {
            o = toRest(pose, o.sub(pose[3], pose[7], pose[11], new Vector3d()));
            d = toRest(pose, d);
        }
        TriangleTree.Hit hit = new TriangleTree.Hit();
        if (!trees[surface].nearestAlongRay(o.x, o.y, o.z, d.x, d.y, d.z, hit)) {
            return Optional.empty();
        }
        double[] weights = {hit.weightA, hit.weightB, hit.weightC};
        double[] normal = new double[3];
        MeshMeasure.triangleCrossProduct(surfaces.get(surface).rest(), hit.triangle, normal);
        boolean alongNormal = d.dot(normal[0], normal[1], normal[2]) > 0;
        return Optional.of(new Crossing(surface, hit.triangle, hit.rayParameter, weights, alongNormal));
    }

    /** Transforms a direction to the rest pose: R^T v. */
    private static Vector3d toRest(float[] pose, Vector3d v) {
        return new Vector3d(
                pose[0] * v.x + pose[4] * v.y + pose[8] * v.z,
                pose[1] * v.x + pose[5] * v.y + pose[9] * v.z,
                pose[2] * v.x + pose[6] * v.y + pose[10] * v.z);
    }

    private Optional<Crossing> intersectTriangles(int surface, float[] positions, Search search) {
        int[] triangles = surfaces.get(surface).rest().triangles();
        Crossing nearest = null;
        Vector3d a = new Vector3d();
        Vector3d e1 = new Vector3d();
        Vector3d e2 = new Vector3d();
        Vector3d p = new Vector3d();
        Vector3d q = new Vector3d();
        for (int t = 0; t < triangles.length; t += 3) {
            set(a, positions, triangles[t]);
            set(e1, positions, triangles[t + 1]).sub(a);
            set(e2, positions, triangles[t + 2]).sub(a);
            search.direction.cross(e2, p);
            double determinant = e1.dot(p);
            search.origin.sub(a, q);
            double v = q.dot(p) / determinant;
            if (!(v >= 0 && v <= 1)) {
                continue;
            }
            q.cross(e1);
            double w = search.direction.dot(q) / determinant;
            double distance = e2.dot(q) / determinant;
            if (w >= 0 && v + w <= 1 && distance >= 0 && (nearest == null || distance < nearest.distance)) {
                nearest = new Crossing(surface, t / 3, distance, new double[] {1 - v - w, v, w}, determinant < 0);
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static Vector3d set(Vector3d v, float[] positions, int vertex) {
        return v.set(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
    }
}
