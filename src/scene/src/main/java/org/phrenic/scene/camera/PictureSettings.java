package org.phrenic.scene.camera;

/**
 * View, size and annotation of a picture.
 *
 * @param view from where
 * @param width pixels
 * @param height pixels
 * @param orthographic parallel projection; else perspective
 * @param zoom enlargement about the middle, 1 for all of the body
 * @param annotated whether annotations are drawn over it
 * @param title of the annotations
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

    /** An annotated picture of all of the body in perspective. */
    public static PictureSettings of(AnatomicalView view, int width, int height, String title) {
        return new PictureSettings(view, width, height, false, 1, true, title);
    }

    /** Camera that shows a box. */
    public Camera camera(double[] bounds) {
        Camera whole = Camera.of(view, bounds, (double) width / height).withProjection(orthographic);
        return whole.zoom(zoom, width / 2.0, height / 2.0, width, height);
    }
}
