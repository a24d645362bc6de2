package org.phrenic.scene.camera;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Ray picking on the CPU. For a rigid surface, the ray is transformed to the rest pose and intersected through a
 * bounding volume tree. For a deforming surface, every triangle is tested (Moeller and Trumbore 1997, doi
 * 10.1080/10867651.1997.10487468), which costs less than refitting a tree. A nearly transparent surface is picked only
 * if the ray hits no surface of higher opacity. What a clip plane removes is not hit.
 */
public final class Picker {
    /** Surfaces with a lower opacity are picked only if no other surface is hit. */
    public static final double MIN_SOLID_OPACITY = 0.6;

    private final List<Surface> surfaces;
    private final TriangleTree[] trees;

    public Picker(List<Surface> surfaces) {
        this.surfaces = List.copyOf(surfaces);
        trees = this.surfaces.stream()
                .map(s -> s.motion() == Surface.Motion.DEFORMING ? null : new TriangleTree(s.rest()))
                .toArray(TriangleTree[]::new);
    }

    /** The part of a ray that is not cut away, and the nearest hit so far: distance, surface, triangle, weights. */
    private static final class Search {
        private final Vector3d origin;
        private final Vector3d direction;
        /** Of the nearest hit, before that of the end of the ray. */
        private double distance = Double.POSITIVE_INFINITY;

        private int surface = -1;
        private int triangle;
        private double[] weights;

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
            } else if (beyond > 0) {
                distance = Double.NEGATIVE_INFINITY;
            }
        }

        void hit(int surfaceHit, int triangleHit, double at, double... barycentric) {
            surface = surfaceHit;
            triangle = triangleHit;
            distance = at;
            weights = barycentric;
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
            Surface s = surfaces.get(i);
            if (opacity.applyAsDouble(s) >= minOpacity) {
                if (trees[i] == null) {
                    intersectTriangles(i, s.rest().triangles(), frame.positions(i), search);
                } else {
                    intersectTree(i, frame.pose(i), search);
                }
            }
        }
        return search.surface < 0 ? Optional.empty() : Optional.of(result(search));
    }

    private PickResult result(Search search) {
        Surface surface = surfaces.get(search.surface);
        TriangleMesh mesh = surface.rest();
        Vector3d at = new Vector3d(search.origin).fma(search.distance, search.direction);
        Vector3d rest = new Vector3d();
        int nearest = 0;
        for (int k = 0; k < 3; k++) {
            int v = mesh.triangles()[3 * search.triangle + k];
            rest.fma(search.weights[k], new Vector3d(mesh.x(v), mesh.y(v), mesh.z(v)));
            nearest = search.weights[k] > search.weights[nearest] ? k : nearest;
        }
        int vertex = mesh.triangles()[3 * search.triangle + nearest];
        return new PickResult(search.surface, surface, numbers(at), vertex, numbers(rest), numbers(search.direction));
    }

    private static double[] numbers(Vector3d v) {
        return new double[] {v.x, v.y, v.z};
    }

    private void intersectTree(int surface, float[] pose, Search search) {
        Vector3d o = search.origin;
        Vector3d d = search.direction;
        if (pose.length > 0) {
            o = toRest(pose, o.sub(pose[3], pose[7], pose[11], new Vector3d()));
            d = toRest(pose, d);
        }
        TriangleTree.Hit hit = new TriangleTree.Hit();
        if (trees[surface].nearestAlongRay(o.x, o.y, o.z, d.x, d.y, d.z, hit) && hit.rayParameter < search.distance) {
            search.hit(surface, hit.triangle, hit.rayParameter, hit.weightA, hit.weightB, hit.weightC);
        }
    }

    /** Transforms a direction to the rest pose: R^T v. */
    private static Vector3d toRest(float[] pose, Vector3d v) {
        return new Vector3d(
                pose[0] * v.x + pose[4] * v.y + pose[8] * v.z,
                pose[1] * v.x + pose[5] * v.y + pose[9] * v.z,
                pose[2] * v.x + pose[6] * v.y + pose[10] * v.z);
    }

    private static void intersectTriangles(int surface, int[] triangles, float[] positions, Search search) {
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
            if (w >= 0 && v + w <= 1 && distance >= 0 && distance < search.distance) {
                search.hit(surface, t / 3, distance, 1 - v - w, v, w);
            }
        }
    }

    private static Vector3d set(Vector3d v, float[] positions, int vertex) {
        return v.set(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
    }
}
