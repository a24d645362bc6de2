package org.phrenic.ui.widget;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;

/** The icon of the program: two domes of a diaphragm. */
public final class AppIcon {
    private AppIcon() {}

    public static List<Image> images() {
        return Stream.of(16, 32, 48, 128).map(AppIcon::image).toList();
    }

    private static Image image(int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.scale(size / 32.0, size / 32.0);
        g.setColor(new Color(0x0f7285));
        g.fill(new RoundRectangle2D.Double(0, 0, 32, 32, 8, 8));
        Path2D domes = new Path2D.Double();
        domes.moveTo(5, 25);
        domes.curveTo(5, 6, 13, 6, 16, 14);
        domes.curveTo(19, 8, 27, 8, 27, 25);
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(2.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(domes);
        g.dispose();
        return image;
    }
}
