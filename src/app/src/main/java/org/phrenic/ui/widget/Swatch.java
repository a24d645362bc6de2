package org.phrenic.ui.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.function.Consumer;
import javax.swing.Icon;

/** A small icon that shows a colour or a line. */
public record Swatch(int width, int height, Consumer<Graphics2D> painter) implements Icon {
    @Override
    public void paintIcon(Component c, Graphics graphics, int x, int y) {
        Graphics2D g = Controls.smooth(graphics);
        g.translate(x, y);
        UIScale.scaleGraphics(g);
        painter.accept(g);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(width);
    }

    @Override
    public int getIconHeight() {
        return UIScale.scale(height);
    }
}
