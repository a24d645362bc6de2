package org.phrenic.scene.camera;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;

/**
 * A part of a picture, drawn by itself. Neighbours overlap, so that what looks at pixels around (darkened edges, lines)
 * meets without a seam.
 *
 * @param x left edge in the whole, pixels
 * @param y lower edge in the whole, pixels
 * @param width pixels
 * @param height pixels
 * @param wholeWidth of the whole picture, pixels
 * @param wholeHeight of the whole picture, pixels
 */
public record Tile(int x, int y, int width, int height, int wholeWidth, int wholeHeight) {
    private static final int OVERLAP_PIXELS = 16;

    public static Tile whole(int width, int height) {
        return new Tile(0, 0, width, height, width, height);
    }

    /** The longest side that can be drawn at once. */
    public static int maxSide(SceneStyle style, int most) {
        return style.transparency() == Transparency.PEELED && style.samples() > 1 ? most / 2 : most;
    }

    /** Tiles with sides up to {@code side} that cover a picture. */
    public static List<Tile> split(int width, int height, int side) {
        if (width <= side && height <= side) {
            return List.of(whole(width, height));
        }
        List<Tile> tiles = new ArrayList<>();
        int step = side - 2 * OVERLAP_PIXELS;
        for (int y = 0; y == 0 || y + 2 * OVERLAP_PIXELS < height; y += step) {
            for (int x = 0; x == 0 || x + 2 * OVERLAP_PIXELS < width; x += step) {
                tiles.add(new Tile(x, y, Math.min(side, width - x), Math.min(side, height - y), width, height));
            }
        }
        return tiles;
    }

    /** The projection of the whole picture, narrowed to this part; column-major. */
    float[] crop(float[] projection) {
        float[] m = projection.clone();
        double scaleX = (double) wholeWidth / width;
        double scaleY = (double) wholeHeight / height;
        double shiftX = (wholeWidth - 2.0 * x - width) / width;
        double shiftY = (wholeHeight - 2.0 * y - height) / height;
        for (int column = 0; column < 4; column++) {
            float w = projection[4 * column + 3];
            m[4 * column] = (float) (scaleX * projection[4 * column] + shiftX * w);
            m[4 * column + 1] = (float) (scaleY * projection[4 * column + 1] + shiftY * w);
        }
        return m;
    }

    /** Puts this part into the whole, but for the inner half of an overlap, which the neighbour draws. */
    public void paste(BufferedImage part, BufferedImage whole) {
        int left = x == 0 ? 0 : OVERLAP_PIXELS;
        int low = y == 0 ? 0 : OVERLAP_PIXELS;
        int[] row = new int[width - left];
        for (int j = low; j < height; j++) {
            int inPart = height - 1 - j;
            part.getRGB(left, inPart, row.length, 1, row, 0, row.length);
            whole.setRGB(x + left, wholeHeight - 1 - (y + j), row.length, 1, row, 0, row.length);
        }
    }
}
