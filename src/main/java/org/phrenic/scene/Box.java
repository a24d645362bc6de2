package org.phrenic.scene;

import java.util.List;
import org.phrenic.geometry.TriangleMesh;

/**
 * The box of a surface at rest, to know about where it is drawn.
 *
 * @param bounds least and greatest x, y, z, mm
 */
record Box(double[] bounds) {
    /** How far a surface may leave its box in a breath, mm. */
    private static final double PLAY_MM = 40;

    static Box of(TriangleMesh mesh) {
        return new Box(mesh.bounds());
    }

    /** What is outside is larger than what it holds. */
    double longestSide() {
        return Math.max(bounds[3] - bounds[0], Math.max(bounds[4] - bounds[1], bounds[5] - bounds[2]));
    }

    /** Distance of the nearest corner in front of the eye, mm: what hides others is best drawn first. */
    double nearest(Sight sight) {
        double nearest = Double.POSITIVE_INFINITY;
        double[] eye = new double[3];
        for (int corner = 0; corner < 8; corner++) {
            place(corner, 0, sight.view(), eye);
            nearest = Math.min(nearest, -eye[2]);
        }
        return nearest;
    }

    /** The pixels that boxes may cover, with room for motion: left, bottom, width, height; all of the picture if a box reaches behind the eye. */
    static int[] pixels(List<Box> boxes, Sight sight) {
        double left = 1;
        double right = -1;
        double low = 1;
        double high = -1;
        double[] eye = new double[3];
        float[] p = sight.projection();
        for (Box box : boxes) {
            for (int corner = 0; corner < 8; corner++) {
                box.place(corner, PLAY_MM, sight.view(), eye);
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

    private void place(int corner, double play, float[] view, double[] eye) {
        double x = (corner & 1) == 0 ? bounds[0] - play : bounds[3] + play;
        double y = (corner & 2) == 0 ? bounds[1] - play : bounds[4] + play;
        double z = (corner & 4) == 0 ? bounds[2] - play : bounds[5] + play;
        for (int row = 0; row < 3; row++) {
            eye[row] = view[row] * x + view[4 + row] * y + view[8 + row] * z + view[12 + row];
        }
    }
}
