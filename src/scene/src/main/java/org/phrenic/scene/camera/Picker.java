package org.phrenic.scene.camera;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Finds what a line of sight meets first, on the processor. A rigid surface is asked in its rest pose, with the ray
 * moved there; a deforming one triangle by triangle where the frame has it (Moeller and Trumbore 1997, doi
 * 10.1080/10867651.1997.10487468), which costs less than drawing a tree about it anew. What is nearly transparent is
 * looked through unless there is nothing behind. Not for two threads at once.
 */
public final class Picker {
    /** Surfaces less opaque than this are looked through. */
    public static final double MIN_SOLID_OPACITY = 0.6;

    private final List<Surface> surfaces;
    private final TriangleTree[] trees;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final double[] ray = new double[6];

    /** Nearest so far: surface, distance along the ray, vertex. */
    private int nearestSurface;

    private double nearestDistance;
    private double maxDistance = Double.POSITIVE_INFINITY;
    private int vertex;
    private int triangle;
    private final double[] weights = new double[3];

    public Picker(List<Surface> surfaces) {
        this.surfaces = List.copyOf(surfaces);
        trees = this.surfaces.stream()
                .map(s -> s.motion() == Surface.Motion.DEFORMING ? null : new TriangleTree(s.rest()))
                .toArray(TriangleTree[]::new);
    }

    /**
     * What a ray meets first.
     *
     * @param frame where the surfaces are
     * @param sight origin and direction, as {@link Camera#ray} gives it
     * @param opacity of a surface, 0 for one that is hidden
     */
    public Optional<PickResult> pick(Frame frame, double[] sight, ToDoubleFunction<Surface> opacity) {
        Optional<PickResult> solid = nearest(frame, sight, opacity, MIN_SOLID_OPACITY);
        return solid.isPresent() ? solid : nearest(frame, sight, opacity, Double.MIN_VALUE);
    }

    /** What a ray meets first of what a style shows, on this side of its clip plane. */
    public Optional<PickResult> pick(Frame frame, double[] sight, SceneStyle style) {
        maxDistance = Double.POSITIVE_INFINITY;
        double[] kept = sight.clone();
        style.clip().ifPresent(plane -> clip(plane, kept));
        Optional<PickResult> pick = pick(frame, kept, s -> style.appearance(s.name())
                .filter(Appearance::visible)
                .map(Appearance::opacity)
                .orElse(0f));
        maxDistance = Double.POSITIVE_INFINITY;
        return pick;
    }

    /** Begins the ray where it enters what is left of the body, or ends it where it leaves that. */
    private void clip(ClipPlane plane, double[] sight) {
        double outside = plane.nx() * sight[0] + plane.ny() * sight[1] + plane.nz() * sight[2] - plane.offsetMm();
        double rate = plane.nx() * sight[3] + plane.ny() * sight[4] + plane.nz() * sight[5];
        double crossing = -outside / rate;
        if (outside <= 0) {
            maxDistance = crossing > 0 ? crossing : Double.POSITIVE_INFINITY;
        } else if (crossing > 0) {
            for (int i = 0; i < 3; i++) {
                sight[i] += crossing * sight[3 + i];
            }
        } else {
            maxDistance = 0;
        }
    }

    private Optional<PickResult> nearest(Frame frame, double[] sight, ToDoubleFunction<Surface> opacity, double least) {
        nearestSurface = -1;
        nearestDistance = maxDistance;
        for (int i = 0; i < surfaces.size(); i++) {
            Surface s = surfaces.get(i);
            if (opacity.applyAsDouble(s) >= least) {
                if (s.motion() == Surface.Motion.DEFORMING) {
                    intersectTriangles(i, s.rest().triangles(), frame.positions(i), sight);
                } else {
                    intersectTree(i, frame.pose(i), sight);
                }
            }
        }
        if (nearestSurface < 0) {
            return Optional.empty();
        }
        Surface s = surfaces.get(nearestSurface);
        return Optional.of(new PickResult(
                nearestSurface,
                s,
                StructureLabels.of(s),
                sight[0] + nearestDistance * sight[3],
                sight[1] + nearestDistance * sight[4],
                sight[2] + nearestDistance * sight[5],
                vertex,
                restPosition(s.rest()),
                new double[] {sight[3], sight[4], sight[5]}));
    }

    /** The same place of the triangle where the surface rests. */
    private double[] restPosition(TriangleMesh mesh) {
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            int corner = mesh.triangles()[3 * triangle + k];
            for (int i = 0; i < 3; i++) {
                at[i] += weights[k] * mesh.positions()[3 * corner + i];
            }
        }
        return at;
    }

    private void storeHit(int triangleFound, double a, double b, double c) {
        triangle = triangleFound;
        weights[0] = a;
        weights[1] = b;
        weights[2] = c;
    }

    private void intersectTree(int surface, float[] pose, double[] sight) {
        if (pose.length == 0) {
            System.arraycopy(sight, 0, ray, 0, ray.length);
        } else {
            transformToRest(pose, sight);
        }
        if (trees[surface].nearestAlongRay(ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], hit)
                && hit.rayParameter < nearestDistance) {
            nearestDistance = hit.rayParameter;
            nearestSurface = surface;
            TriangleMesh mesh = trees[surface].mesh();
            int corner = nearestCorner(hit.weightA, hit.weightB, hit.weightC);
            vertex = mesh.triangles()[3 * hit.triangle + corner];
            storeHit(hit.triangle, hit.weightA, hit.weightB, hit.weightC);
        }
    }

    /** The ray in the rest pose: x = R^T (x' - t). */
    private void transformToRest(float[] pose, double[] sight) {
        for (int i = 0; i < 3; i++) {
            double origin = 0;
            double direction = 0;
            for (int row = 0; row < 3; row++) {
                double turn = pose[4 * row + i];
                origin += turn * (sight[row] - pose[4 * row + 3]);
                direction += turn * sight[3 + row];
            }
            ray[i] = origin;
            ray[3 + i] = direction;
        }
    }

    private void intersectTriangles(int surface, int[] triangles, float[] p, double[] sight) {
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            double e1x = p[b] - p[a];
            double e1y = p[b + 1] - p[a + 1];
            double e1z = p[b + 2] - p[a + 2];
            double e2x = p[c] - p[a];
            double e2y = p[c + 1] - p[a + 1];
            double e2z = p[c + 2] - p[a + 2];
            double px = sight[4] * e2z - sight[5] * e2y;
            double py = sight[5] * e2x - sight[3] * e2z;
            double pz = sight[3] * e2y - sight[4] * e2x;
            double determinant = e1x * px + e1y * py + e1z * pz;
            double tx = sight[0] - p[a];
            double ty = sight[1] - p[a + 1];
            double tz = sight[2] - p[a + 2];
            double v = (tx * px + ty * py + tz * pz) / determinant;
            if (!(v >= 0 && v <= 1)) {
                continue;
            }
            double qx = ty * e1z - tz * e1y;
            double qy = tz * e1x - tx * e1z;
            double qz = tx * e1y - ty * e1x;
            double w = (sight[3] * qx + sight[4] * qy + sight[5] * qz) / determinant;
            double far = (e2x * qx + e2y * qy + e2z * qz) / determinant;
            if (w >= 0 && v + w <= 1 && far >= 0 && far < nearestDistance) {
                nearestDistance = far;
                nearestSurface = surface;
                vertex = triangles[t + nearestCorner(1 - v - w, v, w)];
                storeHit(t / 3, 1 - v - w, v, w);
            }
        }
    }

    private static int nearestCorner(double a, double b, double c) {
        if (a >= b && a >= c) {
            return 0;
        }
        return b >= c ? 1 : 2;
    }
}
