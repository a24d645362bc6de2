package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.RoundRectangle2D;
import javax.swing.JPanel;
import org.phrenic.scene.style.ColourMap;

/** What the colours of the skin mean. */
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
                "From where on the skin the target can be reached: green over the whole breath, amber in part of it; shares of the skin that the needle reaches from");
    }

    /** Says how much of the skin in reach is free and free in part, per cent; less than 0 for not known. */
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
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(new javax.swing.JLabel().getFont());
        int x = 0;
        int baseline = (getHeight()
                        + g.getFontMetrics().getAscent()
                        - g.getFontMetrics().getDescent())
                / 2;
        String skin = "Skin:";
        g.setColor(AdviceColours.secondaryText());
        g.drawString(skin, x, baseline);
        x += g.getFontMetrics().stringWidth(skin) + GAP;
        for (int i = 0; i < NAMES.length; i++) {
            g.setColor(new Color(ColourMap.ACCESS.rgb(FREE_FRACTIONS[i])));
            g.fill(new RoundRectangle2D.Double(x, (getHeight() - SIDE) / 2.0, SIDE, SIDE, 4, 4));
            x += SIDE + 4;
            g.setColor(AdviceColours.secondaryText());
            String text = NAMES[i] + percentTexts[i];
            g.drawString(text, x, baseline);
            x += g.getFontMetrics().stringWidth(text) + 2 * GAP;
        }
        g.dispose();
    }
}
