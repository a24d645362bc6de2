package org.phrenic.scene.camera;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * A part of a picture that is drawn separately. Neighbouring tiles overlap, so that passes which read neighbouring
 * pixels (depth edges, lines) leave no seam.
 *
 * @param x left edge in the whole picture, pixels
 * @param y lower edge in the whole picture, pixels
 * @param width pixels
 * @param height pixels
 * @param wholeWidth width of the whole picture, pixels
 * @param wholeHeight height of the whole picture, pixels
 */
public record Tile(int x, int y, int width, int height, int wholeWidth, int wholeHeight) {
    private static final int LEAST_OVERLAP_PIXELS = 16;

    public static Tile whole(int width, int height) {
        return new Tile(0, 0, width, height, width, height);
    }

    /** Splits a picture into overlapping tiles with sides of at most {@code side} pixels. */
    public static List<Tile> split(int width, int height, int side) {
        if (width <= side && height <= side) {
            return List.of(whole(width, height));
        }
        List<Tile> tiles = new ArrayList<>();
        int overlap = overlap(height);
        int step = side - 2 * overlap;
        for (int y = 0; y == 0 || y + 2 * overlap < height; y += step) {
            for (int x = 0; x == 0 || x + 2 * overlap < width; x += step) {
                tiles.add(new Tile(x, y, Math.min(side, width - x), Math.min(side, height - y), width, height));
            }
        }
        return tiles;
    }

    /**
     * So wide that a point whose centre lies beyond a tile, which is not drawn in it, does not reach what is pasted.
     */
    static int overlap(int wholeHeight) {
        double radius = 0.5 * ViewTransform.GREATEST_POINT * ViewTransform.enlargement(wholeHeight);
        return Math.max(LEAST_OVERLAP_PIXELS, (int) Math.ceil(radius) + 2);
    }

    /** Restricts the projection of the whole picture to this tile. */
    Matrix4d crop(Matrix4dc projection) {
        return new Matrix4d()
                .translation((wholeWidth - 2.0 * x - width) / width, (wholeHeight - 2.0 * y - height) / height, 0)
                .scale((double) wholeWidth / width, (double) wholeHeight / height, 1)
                .mul(projection);
    }

    /** Copies this tile into the whole picture, except the strip of the overlap that the neighbouring tile provides. */
    public void paste(BufferedImage part, BufferedImage whole) {
        int left = x == 0 ? 0 : overlap(wholeHeight);
        int low = y == 0 ? 0 : overlap(wholeHeight);
        whole.getRaster()
                .setRect(
                        x + left,
                        wholeHeight - y - height,
                        part.getRaster().createChild(left, 0, width - left, height - low, 0, 0, null));
    }
}
