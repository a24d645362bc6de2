package org.phrenic.scene.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TileTest {
    private static final int SIDE = 3072;

    /** A point is drawn in a tile if its centre lies in it; half of it may lie in what another tile shows. */
    @ParameterizedTest
    @ValueSource(ints = {3500, 5000, 8192})
    void theLargestPointsReachNoSeam(int height) {
        List<Tile> tiles = Tile.split(1000, height, SIDE);
        double radius = 0.5 * 6 * height / 900;
        for (int i = 1; i < tiles.size(); i++) {
            Tile below = tiles.get(i - 1);
            Tile above = tiles.get(i);
            int seam = above.y() + Tile.overlap(height);
            assertThat(seam - above.y()).as("beyond the seam").isGreaterThan((int) radius);
            assertThat(below.y() + below.height() - seam).as("before it").isGreaterThan((int) radius);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {3500, 8192})
    void tilesCoverThePicture(int height) {
        BufferedImage whole = new BufferedImage(1, height, BufferedImage.TYPE_INT_RGB);
        for (Tile tile : Tile.split(1, height, SIDE)) {
            BufferedImage part = new BufferedImage(tile.width(), tile.height(), BufferedImage.TYPE_INT_RGB);
            for (int y = 0; y < tile.height(); y++) {
                part.setRGB(0, y, 0xffffff);
            }
            tile.paste(part, whole);
        }
        for (int y = 0; y < height; y++) {
            assertThat(whole.getRGB(0, y) & 0xffffff).as("row %d", y).isEqualTo(0xffffff);
        }
    }
}
