package org.phrenic.scene;

/**
 * How a picture is looked at: what all shaders need to know of camera and picture.
 *
 * @param view world to eye coordinates, column-major
 * @param projection eye to clip coordinates of this part of the picture, column-major
 * @param wholeProjection the same of the whole picture
 * @param parallel whether the projection is parallel
 * @param mmPerPixel in the plane that is looked at
 * @param tile part of the picture
 * @param scale pixels that are drawn for one of the picture, along each side
 */
record Sight(
        float[] view,
        float[] projection,
        float[] wholeProjection,
        boolean parallel,
        double mmPerPixel,
        Tile tile,
        int scale) {
    /** Height of a picture for which widths of lines and edges are stated, pixels. */
    private static final float USUAL_HEIGHT = 900;

    static Sight of(Camera camera, Tile tile, int scale) {
        float[] whole = camera.projectionMatrix((double) tile.wholeWidth() / tile.wholeHeight());
        return new Sight(
                camera.viewMatrix(),
                tile.narrow(whole),
                whole,
                camera.orthographic(),
                camera.mmPerPixel(tile.wholeHeight()),
                tile,
                scale);
    }

    int width() {
        return tile.width() * scale;
    }

    int height() {
        return tile.height() * scale;
    }

    /** Pixels that look as wide as {@code usual} do in a picture of the usual height; never less. */
    float pixels(float usual) {
        return usual * scale * Math.max(1, tile.wholeHeight() / USUAL_HEIGHT);
    }

    float parallelFlag() {
        return parallel ? 1 : 0;
    }
}
