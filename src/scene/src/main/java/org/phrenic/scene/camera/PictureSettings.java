package org.phrenic.scene.camera;

/**
 * View, size and annotations of a picture.
 *
 * @param view direction of view
 * @param width pixels
 * @param height pixels
 * @param orthographic whether the projection is parallel instead of perspective
 * @param zoom magnification about the centre; 1 shows the whole body
 * @param annotated whether annotations are drawn over the picture
 * @param title title of the annotations
 */
public record PictureSettings(
        AnatomicalView view,
        int width,
        int height,
        boolean orthographic,
        double zoom,
        boolean annotated,
        String title) {
    public static final int MIN_SIZE = 16;
    public static final int MAX_SIZE = 8192;

    public static PictureSettings of(AnatomicalView view, int width, int height, String title) {
        return new PictureSettings(view, width, height, false, 1, true, title);
    }

    public Camera camera(double[] bounds) {
        Camera whole = Camera.of(view, bounds, (double) width / height).withProjection(orthographic);
        return whole.zoom(zoom, width / 2.0, height / 2.0, width, height);
    }
}
