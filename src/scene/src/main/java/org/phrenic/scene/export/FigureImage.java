package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;

/**
 * A picture of a figure in a report, not yet written.
 *
 * @param name of its file without the extension
 * @param altText what it shows, for readers who do not see it
 * @param caption below this picture
 */
public record FigureImage(String name, String altText, String caption, BufferedImage image) {
    public String fileName() {
        return name + ".png";
    }

    /** Writes it into a folder. */
    public void write(Path folder) {
        PngFile.write(folder.resolve(fileName()), image);
    }
}
