package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;

/** A picture of a figure in a report, drawn and not yet written. */
public final class FigureImage {
    private final String name;
    private final String altText;
    private final String caption;
    private final BufferedImage image;

    /**
     * @param name of its file without the ending
     * @param alternative what it shows, for those who do not see it
     * @param caption below it
     */
    public FigureImage(String name, String alternative, String caption, BufferedImage image) {
        this.name = name;
        this.altText = alternative;
        this.caption = caption;
        this.image = image;
    }

    /** Name of its file. */
    public String fileName() {
        return name + ".png";
    }

    /** What it shows, for those who do not see it. */
    public String altText() {
        return altText;
    }

    /** Caption of this picture alone. */
    public String caption() {
        return caption;
    }

    /** Writes it into a folder. */
    public void write(Path folder) {
        PngFile.write(folder.resolve(fileName()), image);
    }

    BufferedImage image() {
        return image;
    }
}
