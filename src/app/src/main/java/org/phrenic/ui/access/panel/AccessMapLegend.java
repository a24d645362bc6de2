package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.RoundRectangle2D;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Theme;

/** Legend of the access map on the skin. */
public final class AccessMapLegend extends JPanel {
    private static final String[] NAMES = {"free", "in part", "never"};
    private static final double[] FREE_FRACTIONS = {1, 0.6, 0};
    private static final int SIDE = 12;
    private static final int GAP = 6;

    private final String[] percentTexts = {"", "", ""};

    public AccessMapLegend() {
        setOpaque(false);
        getAccessibleContext()
                .setAccessibleName("Colours of the skin: green free, amber part of the breath, plain never");
        setToolTipText(
                "Where on the skin the path to the target is free: green over the whole breath, amber in part of it;"
                        + " percentages of the skin within reach of the needle");
    }

    /** Percentages of the skin within reach whose path is free, always and in part; negative for unknown. */
    public void setPercentages(long free, long part) {
        percentTexts[0] = free < 0 ? "" : " " + free + " %";
        percentTexts[1] = part < 0 ? "" : " " + part + " %";
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(200, 18);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Controls.smooth(graphics);
        g.setFont(new JLabel().getFont());
        int x = 0;
        FontMetrics metrics = g.getFontMetrics();
        int baseline = (getHeight() + metrics.getAscent() - metrics.getDescent()) / 2;
        String skin = "Skin:";
        g.setColor(Theme.SECONDARY_TEXT);
        g.drawString(skin, x, baseline);
        x += metrics.stringWidth(skin) + GAP;
        for (int i = 0; i < NAMES.length; i++) {
            g.setColor(new Color(ColourMap.ACCESS.rgb(FREE_FRACTIONS[i])));
            g.fill(new RoundRectangle2D.Double(x, (getHeight() - SIDE) / 2.0, SIDE, SIDE, 4, 4));
            x += SIDE + 4;
            g.setColor(Theme.SECONDARY_TEXT);
            String text = NAMES[i] + percentTexts[i];
            g.drawString(text, x, baseline);
            x += metrics.stringWidth(text) + 2 * GAP;
        }
        g.dispose();
    }
}
