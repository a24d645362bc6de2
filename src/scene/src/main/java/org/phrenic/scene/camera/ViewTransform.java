package org.phrenic.scene.camera;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.phrenic.scene.style.ClipPlane;

/**
 * The transforms of one picture, shared by all shaders.
 *
 * @param view world to eye coordinates
 * @param projection eye to clip coordinates of this tile
 * @param fullProjection eye to clip coordinates of the whole picture
 * @param orthographic whether the projection is parallel
 * @param tile part of the picture that is drawn
 * @param scale drawn pixels over pixels of the picture along each side: above 1 for supersampling, below for a coarser
 *     picture
 */
public record ViewTransform(
        Matrix4d view, Matrix4d projection, Matrix4d fullProjection, boolean orthographic, Tile tile, double scale) {
    /** Picture height to which line and edge widths refer, pixels. */
    private static final float REFERENCE_HEIGHT = 900;
    /** Diameter of the largest points that are drawn, pixels at the reference height. */
    public static final float GREATEST_POINT = 6;

    public static ViewTransform of(Camera camera, Tile tile, double scale) {
        Matrix4d full = camera.projectionMatrix((double) tile.wholeWidth() / tile.wholeHeight());
        return new ViewTransform(camera.viewMatrix(), tile.crop(full), full, camera.orthographic(), tile, scale);
    }

    public int width() {
        return drawn(tile.width(), scale);
    }

    public int height() {
        return drawn(tile.height(), scale);
    }

    /** Number of pixels drawn for a side of a picture, 1 at least. */
    public static int drawn(int pixels, double scale) {
        return Math.max(1, (int) Math.round(pixels * scale));
    }

    /**
     * Scales a width from the reference height to this picture, drawn pixels. It does not shrink in smaller pictures,
     * and in coarser ones not below one pixel.
     */
    public float scaledPixels(float reference) {
        float scaled = (float) (reference * scale * enlargement(tile.wholeHeight()));
        return scale < 1 ? Math.max(Math.min(1, reference), scaled) : scaled;
    }

    /** Factor of widths in a picture of a height. */
    static float enlargement(int wholeHeight) {
        return Math.max(1, wholeHeight / REFERENCE_HEIGHT);
    }

    public float orthographicFlag() {
        return orthographic ? 1 : 0;
    }

    /** Transform from the rest coordinates of a surface with the given pose to eye coordinates. */
    public Matrix4d toEyeSpace(Matrix4d pose) {
        return view.mul(pose, new Matrix4d());
    }

    /** Clip plane (a, b, c, d) in eye coordinates: {@code a x + b y + c z + d} is positive on the kept side. */
    public float[] clipPlane(Optional<ClipPlane> plane) {
        if (plane.isEmpty()) {
            return new float[] {0, 0, 0, 1};
        }
        ClipPlane p = plane.get();
        Vector3d n = view.transformDirection(new Vector3d(p.nx(), p.ny(), p.nz()));
        double d = p.offsetMm() + n.dot(view.getTranslation(new Vector3d()));
        return new float[] {(float) -n.x, (float) -n.y, (float) -n.z, (float) d};
    }
}
