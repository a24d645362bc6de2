package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;

/**
 * A picture of a report, in memory.
 *
 * @param name file name without the extension
 * @param altText alternative text for accessibility
 * @param caption caption below the picture
 */
public record FigureImage(String name, String altText, String caption, BufferedImage image) {
    public String fileName() {
        return name + ".png";
    }

    public void write(Path folder) {
        PngFile.write(folder.resolve(fileName()), image);
    }
}
