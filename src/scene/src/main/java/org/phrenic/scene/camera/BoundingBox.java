package org.phrenic.scene.camera;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.style.ClipPlane;

/**
 * The axis-aligned bounding box of a surface at rest, mm.
 *
 * @param low minimum x, y, z
 * @param high maximum x, y, z
 */
public record BoundingBox(Vector3d low, Vector3d high) {
    /** Maximum distance by which a surface leaves its box during a breath, mm. */
    private static final double MOTION_MARGIN_MM = 40;

    /** Share of the diagonal by which the bounds of a scene change at most as its organs are shown or hidden. */
    private static final double SAME_BODY = 0.2;

    public static BoundingBox of(TriangleMesh mesh) {
        double[] b = mesh.bounds();
        return new BoundingBox(new Vector3d(b[0], b[1], b[2]), new Vector3d(b[3], b[4], b[5]));
    }

    /**
     * Whether a camera that shows a scene also shows another one.
     *
     * @param bounds of the first scene, {@code {minX, minY, minZ, maxX, maxY, maxZ}}, mm
     * @param others of the other scene
     */
    public static boolean areAlike(double[] bounds, double[] others) {
        double diagonal =
                new Vector3d(bounds[3], bounds[4], bounds[5]).distance(new Vector3d(bounds[0], bounds[1], bounds[2]));
        return IntStream.range(0, bounds.length).noneMatch(i -> Math.abs(others[i] - bounds[i]) > SAME_BODY * diagonal);
    }

    public double longestSide() {
        Vector3d size = high.sub(low, new Vector3d());
        return size.get(size.maxComponent());
    }

    /** Depth of the nearest corner in eye coordinates, mm; negative behind the eye. */
    public double nearestDepth(ViewTransform transform) {
        Vector3d farthest = new Vector3d();
        Vector3d nearest = new Vector3d();
        transform.view().transformAab(low, high, farthest, nearest);
        return -nearest.z;
    }

    private BoundingBox enlarged() {
        Vector3d margin = new Vector3d(MOTION_MARGIN_MM);
        return new BoundingBox(low.sub(margin, new Vector3d()), high.add(margin, new Vector3d()));
    }

    /** The box of a list of points, x y z each. */
    public static BoundingBox of(FloatBuffer points) {
        Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
        Vector3d at = new Vector3d();
        for (int i = 0; i < points.limit(); i += 3) {
            at.set(points.get(i), points.get(i + 1), points.get(i + 2));
            low.min(at);
            high.max(at);
        }
        return new BoundingBox(low, high);
    }

    /** The axis-aligned box that encloses two boxes. */
    public BoundingBox with(BoundingBox other) {
        return new BoundingBox(low.min(other.low, new Vector3d()), high.max(other.high, new Vector3d()));
    }

    /** The axis-aligned box that encloses this one after a transform. */
    public BoundingBox moved(Matrix4d pose) {
        Vector3d newLow = new Vector3d();
        Vector3d newHigh = new Vector3d();
        pose.transformAab(low, high, newLow, newHigh);
        return new BoundingBox(newLow, newHigh);
    }

    /** Corners of a square in a plane that covers the section of the box. Triangle strip in eye coordinates, mm. */
    public float[] sectionQuad(ClipPlane plane, ViewTransform transform) {
        Vector3d normal = new Vector3d(plane.nx(), plane.ny(), plane.nz());
        Vector3d centre = low.add(high, new Vector3d()).mul(0.5);
        Vector3d size = high.sub(low, new Vector3d());
        double radius = size.x + size.y + size.z;
        centre.fma(plane.offsetMm() - normal.dot(centre), normal);
        Matrix4d toEye = transform
                .view()
                .translate(centre, new Matrix4d())
                .rotate(new Quaterniond().rotationTo(new Vector3d(0, 0, 1), normal));
        float[] corners = new float[12];
        for (int corner = 0; corner < 4; corner++) {
            Vector3d at = toEye.transformPosition(
                    new Vector3d((corner & 1) == 0 ? -radius : radius, (corner & 2) == 0 ? -radius : radius, 0));
            corners[3 * corner] = (float) at.x;
            corners[3 * corner + 1] = (float) at.y;
            corners[3 * corner + 2] = (float) at.z;
        }
        return corners;
    }

    /**
     * Pixel rectangle (left, bottom, width, height) that encloses the section of the box with a plane. Of a section
     * beside the picture it is a strip along the border.
     *
     * @param pose transform of the box to world coordinates
     * @return empty if the plane does not meet the box
     */
    public Optional<int[]> sectionRectangle(Matrix4d pose, ClipPlane plane, ViewTransform transform) {
        Vector3d normal = new Vector3d(plane.nx(), plane.ny(), plane.nz());
        Vector3d[] corners = new Vector3d[8];
        double[] beyond = new double[8];
        for (int i = 0; i < 8; i++) {
            corners[i] = pose.transformPosition(corner(i));
            beyond[i] = normal.dot(corners[i]) - plane.offsetMm();
        }
        List<Vector3d> section = new ArrayList<>();
        for (int from = 0; from < 8; from++) {
            for (int axis = 1; axis < 8; axis <<= 1) {
                int to = from | axis;
                if (beyond[from] > 0 != beyond[to] > 0) {
                    section.add(corners[from].lerp(
                            corners[to], beyond[from] / (beyond[from] - beyond[to]), new Vector3d()));
                }
            }
        }
        int[] part = section.isEmpty() ? new int[4] : rectangle(section, transform);
        return part[2] > 0 && part[3] > 0 ? Optional.of(part) : Optional.empty();
    }

    private Vector3d corner(int i) {
        return new Vector3d(
                (i & 1) == 0 ? low.x : high.x, (i & 2) == 0 ? low.y : high.y, (i & 4) == 0 ? low.z : high.z);
    }

    /**
     * Pixel rectangle (left, bottom, width, height) that encloses the boxes with a margin for motion. The whole picture
     * if a box reaches behind the eye.
     */
    public static int[] screenRectangle(List<BoundingBox> boxes, ViewTransform transform) {
        List<Vector3d> corners = new ArrayList<>();
        for (BoundingBox box : boxes) {
            BoundingBox margin = box.enlarged();
            IntStream.range(0, 8).mapToObj(margin::corner).forEach(corners::add);
        }
        return rectangle(corners, transform);
    }

    /** Pixel rectangle that encloses some points, with a pixel about them. */
    private static int[] rectangle(List<Vector3d> points, ViewTransform transform) {
        Matrix4d toClip = transform.projection().mul(transform.view(), new Matrix4d());
        Vector2d least = new Vector2d(1);
        Vector2d greatest = new Vector2d(-1);
        for (Vector3d point : points) {
            Vector4d at = toClip.transform(new Vector4d(point, 1));
            if (!(at.w > 0)) {
                return new int[] {0, 0, transform.width(), transform.height()};
            }
            Vector2d xy = new Vector2d(at.x, at.y).div(at.w);
            least.min(xy);
            greatest.max(xy);
        }
        int left = pixel(least.x, transform.width(), -1);
        int bottom = pixel(least.y, transform.height(), -1);
        return new int[] {
            left,
            bottom,
            Math.max(0, pixel(greatest.x, transform.width(), 1) - left),
            Math.max(0, pixel(greatest.y, transform.height(), 1) - bottom)
        };
    }

    private static int pixel(double clip, int size, int margin) {
        return (int) Math.max(0, Math.min(size, Math.round((clip + 1) / 2 * size) + margin));
    }
}
