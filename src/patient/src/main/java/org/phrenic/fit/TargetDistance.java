package org.phrenic.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.fit.search.DistanceGradient;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.observe.Surface;

/**
 * Symmetric, area-weighted distance between a part of a body and a target, measured from the vertices of each to the
 * surface of the other. For the base of a lung, only its vertices ({@link LungBaseVertices}) are used on either side.
 * Their nearest points may lie anywhere on the lung, so the exact border of the base does not matter.
 *
 * <p>Not thread-safe.
 */
final class TargetDistance {
    /** Greatest ratio between the sizes of a target and of its part: a lung in centimetres is a tenth. */
    private static final double SIZE_RATIO = 5;
    /**
     * Greatest distance as a share of the size of the part: of points from the part, and of the centre of a surface
     * from the box of the part or of the part's centre from the surface's box. A mirrored lung meets its part's box.
     */
    private static final double GAP_SHARE = 0.1;

    private final FitTarget target;
    private final List<Integer> surfaces = new ArrayList<>();
    private final TriangleMesh rest;
    private final SurfaceDistance fromModel;
    private final SurfaceDistance fromTarget;
    private final boolean[] modelBase;
    private final boolean[] targetBase;
    private final double[] targetAreas;
    private final Anchors anchors;

    /**
     * @param scene scene of the body
     * @throws BadInputException if the body lacks the part, or if the target is of another size or beside it
     */
    TargetDistance(FitTarget target, SceneSurfaces scene) {
        this.target = target;
        List<Surface> all = scene.surfaces();
        for (int i = 0; i < all.size(); i++) {
            if (target.part().matches(all.get(i)) && all.get(i).motion() != Surface.Motion.STILL) {
                surfaces.add(i);
            }
        }
        if (surfaces.isEmpty()) {
            throw new BadInputException("target " + target.name() + ": found no "
                    + target.part().label() + " that moves in the body, expected a part that it has");
        }
        rest = joined(i -> all.get(i).rest());
        requirePlace(target, rest.bounds());
        if (target.isPointPairs()) {
            anchors = new Anchors(rest, target.from());
            fromModel = null;
            fromTarget = null;
            modelBase = null;
            targetBase = null;
            targetAreas = new double[0];
        } else {
            anchors = null;
            fromModel = new SurfaceDistance(rest);
            fromTarget = new SurfaceDistance(target.surface());
            modelBase = target.part().isBase() ? base(rest, "the body's lung") : null;
            targetBase = target.part().isBase() ? base(target.surface(), "its surface") : null;
            targetAreas = MeshMeasure.vertexAreas(target.surface());
        }
    }

    /** Refuses a target in another unit or other axes than the body. */
    static void requirePlace(FitTarget target, double[] part) {
        double[] box = new double[6];
        double[] points =
                target.isPointPairs() ? target.from() : target.surface().positions();
        BoundingBoxes.around(points, 0, points.length, box, 0);
        double size = diagonal(box);
        double wanted = diagonal(part);
        boolean isOfSize = target.isPointPairs() || (size * SIZE_RATIO > wanted && size < wanted * SIZE_RATIO);
        double gap = target.isPointPairs() ? gap(box, part) : Math.min(centreGap(box, part), centreGap(part, box));
        if (!isOfSize || gap > wanted * GAP_SHARE) {
            throw new BadInputException(Numbers.format(
                    "target %s: found it %.1f mm wide and %.1f mm away from %s of the body, which is %.1f mm wide,"
                            + " expected mm in the axes of the body",
                    target.name(), size, gap, target.part().label(), wanted));
        }
    }

    private static double diagonal(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Distance between two boxes; 0 where they meet. */
    private static double gap(double[] a, double[] b) {
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double apart = Math.max(0, Math.max(a[axis] - b[3 + axis], b[axis] - a[3 + axis]));
            squared += apart * apart;
        }
        return Math.sqrt(squared);
    }

    /** Distance of the centre of a box from another box; 0 within. */
    private static double centreGap(double[] of, double[] to) {
        return Math.sqrt(
                BoundingBoxes.squaredDistance(to, 0, (of[0] + of[3]) / 2, (of[1] + of[4]) / 2, (of[2] + of[5]) / 2));
    }

    private boolean[] base(TriangleMesh lung, String whose) {
        boolean[] base = LungBaseVertices.of(lung);
        if (IntStream.range(0, base.length).noneMatch(v -> base[v])) {
            throw new BadInputException("target " + target.name() + ": found nothing that faces down in " + whose
                    + ", expected a whole lung with a base");
        }
        return base;
    }

    FitTarget target() {
        return target;
    }

    /** Distances of the part at rest. */
    FitDistances atRest(FitHalf half) {
        return of(rest, half);
    }

    /** Distances of the part in the current state of the body. */
    FitDistances of(InspiratoryHold breath, FitHalf half) {
        return of(joined(breath::mesh), half);
    }

    /**
     * {@link FitDistances#mean} for the given vertex positions of the part. Distances with weight 0 are not computed.
     */
    double mean(double[] positions, FitHalf half) {
        TriangleMesh model = rest.withPositions(positions);
        if (anchors != null) {
            return of(model, half).mean();
        }
        fromModel.refit(positions);
        double[] weights = weights(MeshMeasure.vertexAreas(model), modelBase, rest, half);
        double[] targetWeights = weights(targetAreas, targetBase, target.surface(), half);
        double sum = weightedSum(fromTarget, model, weights) + weightedSum(fromModel, target.surface(), targetWeights);
        double total =
                Arrays.stream(weights).sum() + Arrays.stream(targetWeights).sum();
        return total > 0 ? sum / total : 0;
    }

    private static double weightedSum(SurfaceDistance from, TriangleMesh of, double[] weights) {
        double sum = 0;
        for (int v = 0; v < weights.length; v++) {
            if (weights[v] > 0) {
                sum += weights[v] * from.unsignedDistance(of.x(v), of.y(v), of.z(v));
            }
        }
        return sum;
    }

    /** Vertex positions of the part in the current state of the body. */
    double[] positions(InspiratoryHold breath) {
        return joined(breath::mesh).positions();
    }

    /** Length of {@link #positions}. */
    int length() {
        return rest.positions().length;
    }

    /** Whether another distance uses the same surfaces of the body. */
    boolean sharesSurfaces(TargetDistance other) {
        return surfaces.equals(other.surfaces);
    }

    /** Gradient of the mean distance. Not available for point pairs. */
    DistanceGradient gradient(FitHalf half) {
        double[] all = new double[rest.vertexCount()];
        Arrays.fill(all, 1);
        return new DistanceGradient(
                rest,
                weights(all, modelBase, rest, half),
                target.surface(),
                weights(targetAreas, targetBase, target.surface(), half));
    }

    private FitDistances of(TriangleMesh model, FitHalf half) {
        if (anchors != null) {
            double[] distances = anchors.distances(model, target.to());
            double[] weights = new double[distances.length];
            for (int i = 0; i < weights.length; i++) {
                weights[i] = half.contains(target.to()[3 * i], target.to()[3 * i + 1]) ? 1 : 0;
            }
            return new FitDistances(null, distances, weights, new double[0], new double[0]);
        }
        fromModel.refit(model.positions());
        double[] areas = MeshMeasure.vertexAreas(model);
        return new FitDistances(
                model,
                fromTarget.unsignedDistance(model.positions()),
                weights(areas, modelBase, rest, half),
                fromModel.unsignedDistance(target.surface().positions()),
                weights(targetAreas, targetBase, target.surface(), half));
    }

    private static double[] weights(double[] areas, boolean[] base, TriangleMesh place, FitHalf half) {
        double[] weights = areas.clone();
        for (int v = 0; v < weights.length; v++) {
            if ((base != null && !base[v]) || !half.contains(place.x(v), place.y(v))) {
                weights[v] = 0;
            }
        }
        return weights;
    }

    /** Joins the surfaces of the part into one mesh. */
    private TriangleMesh joined(IntFunction<TriangleMesh> meshes) {
        return MeshMerge.merge(surfaces.stream().map(meshes::apply).toList());
    }

    /**
     * Points attached to a surface. Each point keeps its offset from the surface point that is nearest to it at rest.
     */
    private static final class Anchors {
        private final int[] corners;
        private final double[] weights;
        private final double[] offsets;

        Anchors(TriangleMesh rest, double[] points) {
            TriangleTree tree = new TriangleTree(rest);
            TriangleTree.Hit hit = new TriangleTree.Hit();
            corners = new int[points.length];
            weights = new double[points.length];
            offsets = new double[points.length];
            for (int i = 0; i < points.length; i += 3) {
                tree.closest(points[i], points[i + 1], points[i + 2], hit);
                if (hit.triangle < 0) {
                    throw new BadInputException("found a point at " + points[i] + ", " + points[i + 1] + ", "
                            + points[i + 2] + " mm, expected one near the body");
                }
                for (int c = 0; c < 3; c++) {
                    corners[i + c] = rest.triangles()[3 * hit.triangle + c];
                }
                weights[i] = hit.weightA;
                weights[i + 1] = hit.weightB;
                weights[i + 2] = hit.weightC;
                offsets[i] = points[i] - hit.x;
                offsets[i + 1] = points[i + 1] - hit.y;
                offsets[i + 2] = points[i + 2] - hit.z;
            }
        }

        double[] distances(TriangleMesh model, double[] to) {
            double[] p = model.positions();
            double[] out = new double[to.length / 3];
            for (int i = 0; i < to.length; i += 3) {
                double squares = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double at = offsets[i + axis];
                    for (int c = 0; c < 3; c++) {
                        at += weights[i + c] * p[3 * corners[i + c] + axis];
                    }
                    squares += (at - to[i + axis]) * (at - to[i + axis]);
                }
                out[i / 3] = Math.sqrt(squares);
            }
            return out;
        }
    }
}
