package org.phrenic.scene.camera;

import java.util.List;
import org.joml.Intersectiond;
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

    public static BoundingBox of(TriangleMesh mesh) {
        double[] b = mesh.bounds();
        return new BoundingBox(new Vector3d(b[0], b[1], b[2]), new Vector3d(b[3], b[4], b[5]));
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

    /** Whether a plane intersects the box enlarged by the motion margin. */
    public boolean mayIntersect(ClipPlane plane) {
        BoundingBox box = enlarged();
        return Intersectiond.testAabPlane(box.low, box.high, plane.nx(), plane.ny(), plane.nz(), -plane.offsetMm());
    }

    private BoundingBox enlarged() {
        Vector3d margin = new Vector3d(MOTION_MARGIN_MM);
        return new BoundingBox(low.sub(margin, new Vector3d()), high.add(margin, new Vector3d()));
    }

    /**
     * Corners of a square in a plane that covers the section of the box with a margin for motion. Triangle strip in eye
     * coordinates, mm.
     */
    public float[] sectionQuad(ClipPlane plane, ViewTransform transform) {
        Vector3d normal = new Vector3d(plane.nx(), plane.ny(), plane.nz());
        Vector3d centre = low.add(high, new Vector3d()).mul(0.5);
        Vector3d size = high.sub(low, new Vector3d());
        double radius = MOTION_MARGIN_MM + size.x + size.y + size.z;
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
     * Pixel rectangle (left, bottom, width, height) that encloses the boxes with a margin for motion. The whole picture
     * if a box reaches behind the eye.
     */
    public static int[] screenRectangle(List<BoundingBox> boxes, ViewTransform transform) {
        Matrix4d toClip = transform.projection().mul(transform.view(), new Matrix4d());
        Vector2d least = new Vector2d(1);
        Vector2d greatest = new Vector2d(-1);
        for (BoundingBox box : boxes) {
            BoundingBox b = box.enlarged();
            for (int corner = 0; corner < 8; corner++) {
                Vector4d at = toClip.transform(new Vector4d(
                        (corner & 1) == 0 ? b.low.x : b.high.x,
                        (corner & 2) == 0 ? b.low.y : b.high.y,
                        (corner & 4) == 0 ? b.low.z : b.high.z,
                        1));
                if (!(at.w > 0)) {
                    return new int[] {0, 0, transform.width(), transform.height()};
                }
                Vector2d xy = new Vector2d(at.x, at.y).div(at.w);
                least.min(xy);
                greatest.max(xy);
            }
        }
        int left = pixel(least.x, transform.width());
        int bottom = pixel(least.y, transform.height());
        return new int[] {
            left,
            bottom,
            Math.max(0, pixel(greatest.x, transform.width()) - left),
            Math.max(0, pixel(greatest.y, transform.height()) - bottom)
        };
    }

    private static int pixel(double clip, int size) {
        return (int) Math.round(Math.max(0, Math.min(1, (clip + 1) / 2)) * size);
    }
}
