package org.phrenic.ui.widget;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;

/**
 * The toolbar's signs, drawn as shapes on a 16 x 16 grid so that they are sharp at any scale and take the colour of the
 * text.
 */
public enum Icons implements Icon {
    PLAY {
        @Override
        void draw(Graphics2D g) {
            g.fill(polygon(4, 2.5, 13.5, 8, 4, 13.5));
        }
    },
    PAUSE {
        @Override
        void draw(Graphics2D g) {
            g.fill(new Rectangle2D.Double(3.5, 3, 3.2, 10));
            g.fill(new Rectangle2D.Double(9.3, 3, 3.2, 10));
        }
    },
    STEP {
        @Override
        void draw(Graphics2D g) {
            g.fill(polygon(3, 3, 10, 8, 3, 13));
            g.fill(new Rectangle2D.Double(11, 3, 2, 10));
        }
    },
    RESET {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(new Arc2D.Double(3, 3.2, 10, 10, 130, -300, Arc2D.OPEN));
            g.fill(polygon(1.6, 5.8, 6.6, 6.2, 4, 1.6));
        }
    },
    HOLD {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.5f));
            g.draw(new Ellipse2D.Double(2, 2, 12, 12));
            g.fill(new Rectangle2D.Double(5.4, 5.2, 1.9, 5.6));
            g.fill(new Rectangle2D.Double(8.7, 5.2, 1.9, 5.6));
        }
    },
    CAMERA {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.4f));
            g.draw(new Rectangle2D.Double(1.7, 4.5, 12.6, 8.6));
            g.draw(new Ellipse2D.Double(5.4, 6.2, 5.2, 5.2));
            g.fill(new Rectangle2D.Double(5.2, 2.4, 5.6, 2.4));
        }
    },
    THEME {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.5f));
            g.draw(new Ellipse2D.Double(2, 2, 12, 12));
            g.fill(new Arc2D.Double(2, 2, 12, 12, -90, 180, Arc2D.PIE));
        }
    },
    MESH {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(polygon(8, 2, 14.5, 13.5, 1.5, 13.5));
            g.draw(polygon(4.75, 7.75, 11.25, 7.75, 8, 13.5));
        }
    },
    CLOSE {
        @Override
        void draw(Graphics2D g) {
            g.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(line(4, 4, 12, 12));
            g.draw(line(12, 4, 4, 12));
        }
    };

    private static final int SIZE = 16;

    abstract void draw(Graphics2D g);

    private static Path2D polygon(double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            path.lineTo(xy[i], xy[i + 1]);
        }
        path.closePath();
        return path;
    }

    private static Path2D line(double x1, double y1, double x2, double y2) {
        Path2D path = new Path2D.Double();
        path.moveTo(x1, y1);
        path.lineTo(x2, y2);
        return path;
    }

    @Override
    public void paintIcon(Component c, Graphics graphics, int x, int y) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.translate(x, y);
        g.setColor(c.isEnabled() ? c.getForeground() : Theme.secondaryText());
        draw(g);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return SIZE;
    }

    @Override
    public int getIconHeight() {
        return SIZE;
    }
}
