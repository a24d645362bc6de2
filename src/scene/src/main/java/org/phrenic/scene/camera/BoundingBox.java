package org.phrenic.scene.camera;

import java.util.List;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.style.ClipPlane;

/**
 * The box of a surface at rest, to know about where it is drawn.
 *
 * @param bounds least and greatest x, y, z, mm
 */
public record BoundingBox(double[] bounds) {
    /** How far a surface may leave its box in a breath, mm. */
    private static final double MOTION_MARGIN_MM = 40;

    public static BoundingBox of(TriangleMesh mesh) {
        return new BoundingBox(mesh.bounds());
    }

    /** What is outside is larger than what it holds. */
    public double longestSide() {
        return Math.max(bounds[3] - bounds[0], Math.max(bounds[4] - bounds[1], bounds[5] - bounds[2]));
    }

    /** Distance of the nearest corner in front of the eye, mm: what hides others is best drawn first. */
    public double nearestDepth(ViewTransform sight) {
        double nearest = Double.POSITIVE_INFINITY;
        double[] eye = new double[3];
        for (int corner = 0; corner < 8; corner++) {
            cornerInEyeSpace(corner, 0, sight.view(), eye);
            nearest = Math.min(nearest, -eye[2]);
        }
        return nearest;
    }

    /** Whether a plane may cut what is in the box, with room for motion. */
    public boolean mayIntersect(ClipPlane plane) {
        double reach = 0;
        double middle = -plane.offsetMm();
        double[] n = {plane.nx(), plane.ny(), plane.nz()};
        for (int i = 0; i < 3; i++) {
            middle += n[i] * (bounds[i] + bounds[3 + i]) / 2;
            reach += Math.abs(n[i]) * ((bounds[3 + i] - bounds[i]) / 2 + MOTION_MARGIN_MM);
        }
        return Math.abs(middle) <= reach;
    }

    /**
     * Corners, in the order of a strip and in eye coordinates, of a square in a plane that covers the section of the
     * box, with room for motion.
     */
    public float[] sectionQuad(ClipPlane plane, float[] view) {
        double[] n = {plane.nx(), plane.ny(), plane.nz()};
        double[] middle = new double[3];
        double away = -plane.offsetMm();
        double radius = MOTION_MARGIN_MM;
        for (int i = 0; i < 3; i++) {
            middle[i] = (bounds[i] + bounds[3 + i]) / 2;
            away += n[i] * middle[i];
            radius += bounds[3 + i] - bounds[i];
        }
        // Any direction across the normal: the axis that it leans on least.
        int axis = Math.abs(n[0]) < Math.abs(n[1])
                ? (Math.abs(n[0]) < Math.abs(n[2]) ? 0 : 2)
                : (Math.abs(n[1]) < Math.abs(n[2]) ? 1 : 2);
        double[] u = {-n[axis] * n[0], -n[axis] * n[1], -n[axis] * n[2]};
        u[axis] += 1;
        double length = Math.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        double[] w = {
            (n[1] * u[2] - n[2] * u[1]) / length,
            (n[2] * u[0] - n[0] * u[2]) / length,
            (n[0] * u[1] - n[1] * u[0]) / length
        };
        float[] corners = new float[12];
        for (int corner = 0; corner < 4; corner++) {
            double a = (corner & 1) == 0 ? -radius : radius;
            double b = (corner & 2) == 0 ? -radius : radius;
            double[] x = new double[3];
            for (int i = 0; i < 3; i++) {
                x[i] = middle[i] - away * n[i] + a * u[i] / length + b * w[i];
            }
            for (int row = 0; row < 3; row++) {
                corners[3 * corner + row] =
                        (float) (view[row] * x[0] + view[4 + row] * x[1] + view[8 + row] * x[2] + view[12 + row]);
            }
        }
        return corners;
    }

    /**
     * The pixels that boxes may cover, with room for motion: left, bottom, width, height; all of the picture if a box
     * reaches behind the eye.
     */
    public static int[] screenRectangle(List<BoundingBox> boxes, ViewTransform sight) {
        double left = 1;
        double right = -1;
        double low = 1;
        double high = -1;
        double[] eye = new double[3];
        float[] p = sight.projection();
        for (BoundingBox box : boxes) {
            for (int corner = 0; corner < 8; corner++) {
                box.cornerInEyeSpace(corner, MOTION_MARGIN_MM, sight.view(), eye);
                double w = p[11] * eye[2] + p[15];
                if (!(w > 0)) {
                    return new int[] {0, 0, sight.width(), sight.height()};
                }
                double x = (p[0] * eye[0] + p[8] * eye[2] + p[12]) / w;
                double y = (p[5] * eye[1] + p[9] * eye[2] + p[13]) / w;
                left = Math.min(left, x);
                right = Math.max(right, x);
                low = Math.min(low, y);
                high = Math.max(high, y);
            }
        }
        int x0 = pixel(left, sight.width());
        int y0 = pixel(low, sight.height());
        return new int[] {
            x0, y0, Math.max(0, pixel(right, sight.width()) - x0), Math.max(0, pixel(high, sight.height()) - y0)
        };
    }

    private static int pixel(double clip, int size) {
        return (int) Math.round(Math.max(0, Math.min(1, (clip + 1) / 2)) * size);
    }

    private void cornerInEyeSpace(int corner, double play, float[] view, double[] eye) {
        double x = (corner & 1) == 0 ? bounds[0] - play : bounds[3] + play;
        double y = (corner & 2) == 0 ? bounds[1] - play : bounds[4] + play;
        double z = (corner & 4) == 0 ? bounds[2] - play : bounds[5] + play;
        for (int row = 0; row < 3; row++) {
            eye[row] = view[row] * x + view[4 + row] * y + view[8 + row] * z + view[12 + row];
        }
    }
}
