package org.phrenic.ui.chart;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Theme;

/** Colour and name of a respiratory phase. The colours can be told apart with colour vision deficiency. */
public final class PhaseColours {
    static final Color TEXT = Theme.colour(0x1E2428, 0xF2F4F5);

    /** Room that a band keeps beside its name, pixels. */
    private static final double NAME_MARGIN = 8;

    /** Size of the smallest letters of a name, relative to those of the component. */
    private static final double SMALLEST_LETTERS = 0.8;

    private static final Map<RespiratoryPhase, Color> COLOURS = new EnumMap<>(Map.of(
            RespiratoryPhase.INSPIRATION, Theme.colour(0xA9D3F0, 0x2F6F9F),
            RespiratoryPhase.EXPIRATION, Theme.colour(0xF8CFA4, 0x93592A),
            RespiratoryPhase.PAUSE, Theme.colour(0xD9DEE2, 0x4A5157),
            RespiratoryPhase.HOLD, Theme.colour(0xD3C4F1, 0x665096)));

    private PhaseColours() {}

    public static Color of(RespiratoryPhase phase) {
        return COLOURS.get(phase);
    }

    public static String displayName(RespiratoryPhase phase) {
        return Controls.capitalise(phase.label());
    }

    /** The phase of a status label; a pause if there is none of that name. */
    public static RespiratoryPhase parseLabel(String label) {
        Stream<RespiratoryPhase> all = Arrays.stream(RespiratoryPhase.values());
        return all.filter(p -> p.name().equalsIgnoreCase(label)).findFirst().orElse(RespiratoryPhase.PAUSE);
    }

    /** Paints a band of a phase, with its name where there is room, if need be in smaller letters. */
    static void paintBand(Graphics2D g, Rectangle2D band, RespiratoryPhase phase, boolean current) {
        g.setColor(current ? of(phase) : Theme.withAlpha(of(phase), 110));
        g.fill(band);
        String name = displayName(phase);
        Font usual = g.getFont();
        double room = (band.getWidth() - NAME_MARGIN) / g.getFontMetrics().stringWidth(name);
        if (room > SMALLEST_LETTERS) {
            g.setFont(usual.deriveFont((float) (usual.getSize2D() * Math.min(1, room))));
            FontMetrics metrics = g.getFontMetrics();
            g.setColor(current ? TEXT : Theme.SECONDARY_TEXT);
            g.drawString(name, (float) (band.getCenterX() - metrics.stringWidth(name) / 2.0), (float)
                    (band.getCenterY() + (metrics.getAscent() - metrics.getDescent()) / 2.0));
            g.setFont(usual);
        }
    }
}
