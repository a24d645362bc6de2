package org.phrenic.scene.camera;

import java.util.Optional;
import org.phrenic.scene.style.ClipPlane;

/**
 * How a picture is looked at: what all shaders need to know of camera and picture.
 *
 * @param view world to eye coordinates, column-major
 * @param projection eye to clip coordinates of this part of the picture, column-major
 * @param fullProjection the same of the whole picture
 * @param orthographic whether the projection is parallel
 * @param mmPerPixel in the plane that is looked at
 * @param tile part of the picture
 * @param scale pixels that are drawn for one of the picture, along each side
 */
public record ViewTransform(
        float[] view,
        float[] projection,
        float[] fullProjection,
        boolean orthographic,
        double mmPerPixel,
        Tile tile,
        int scale) {
    /** Height of a picture for which widths of lines and edges are stated, pixels. */
    private static final float REFERENCE_HEIGHT = 900;

    public static ViewTransform of(Camera camera, Tile tile, int scale) {
        float[] whole = camera.projectionMatrix((double) tile.wholeWidth() / tile.wholeHeight());
        return new ViewTransform(
                camera.viewMatrix(),
                tile.crop(whole),
                whole,
                camera.orthographic(),
                camera.mmPerPixel(tile.wholeHeight()),
                tile,
                scale);
    }

    public int width() {
        return tile.width() * scale;
    }

    public int height() {
        return tile.height() * scale;
    }

    /** Pixels that look as wide as {@code usual} do in a picture of the usual height; never less. */
    public float scaledPixels(float usual) {
        return usual * scale * Math.max(1, tile.wholeHeight() / REFERENCE_HEIGHT);
    }

    public float orthographicFlag() {
        return orthographic ? 1 : 0;
    }

    /** From a surface's own coordinates to eye coordinates, column-major. */
    public float[] toEyeSpace(float[] pose) {
        float[] m = new float[16];
        for (int column = 0; column < 4; column++) {
            for (int row = 0; row < 4; row++) {
                double sum = 0;
                for (int k = 0; k < 4; k++) {
                    sum += (double) view[4 * k + row] * pose[4 * column + k];
                }
                m[4 * column + row] = (float) sum;
            }
        }
        return m;
    }

    /**
     * The plane that cuts, in eye coordinates as shaders want it: {@code a x + b y + c z + d} is positive for what is
     * kept.
     */
    public float[] clipPlane(Optional<ClipPlane> plane) {
        if (plane.isEmpty()) {
            return new float[] {0, 0, 0, 1};
        }
        ClipPlane c = plane.get();
        float[] eye = new float[4];
        double away = c.offsetMm();
        for (int row = 0; row < 3; row++) {
            double n = view[row] * c.nx() + view[4 + row] * c.ny() + view[8 + row] * c.nz();
            eye[row] = (float) -n;
            away += n * view[12 + row];
        }
        eye[3] = (float) away;
        return eye;
    }
}
