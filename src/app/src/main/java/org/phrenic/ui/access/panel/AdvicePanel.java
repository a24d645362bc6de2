package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Graphics;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.ui.widget.Theme;

/** A headline in green, amber or red, and the reasons for it; in plain colours while a worse one is shown. */
public final class AdvicePanel extends JPanel {
    private static final int BAR_WIDTH = 5;
    /** Green, amber and red; they differ in lightness too. */
    private static final Map<PathAdvice.Level, Color> BACKGROUNDS = new EnumMap<>(Map.of(
            PathAdvice.Level.FREE, Theme.colour(0xe2f3f0, 0x17383a),
            PathAdvice.Level.CAREFUL, Theme.colour(0xfff2d6, 0x463510),
            PathAdvice.Level.BARRED, Theme.colour(0xfbe3df, 0x52241e)));

    private static final Map<PathAdvice.Level, Color> TEXTS = new EnumMap<>(Map.of(
            PathAdvice.Level.FREE, Theme.colour(0x0a4a43, 0xc9f0ea),
            PathAdvice.Level.CAREFUL, Theme.colour(0x5c3c00, 0xffe1a3),
            PathAdvice.Level.BARRED, Theme.colour(0x7a1a0e, 0xffd0c8)));

    private final WrappingLabel headline = WrappingLabel.emphasised("Verdict on the path");
    private final WrappingLabel body = WrappingLabel.normal("Reasons and margin");
    private PathAdvice.Level level = PathAdvice.Level.FREE;
    private boolean unknown;
    private boolean plain;

    /** @param name what the advice is about, such as "Path at present" */
    public AdvicePanel(String name) {
        super(new MigLayout("insets 6 13 6 8, gap 0 1, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        add(headline, "wmin 0");
        add(body, "wmin 0");
        setName(name);
        getAccessibleContext().setAccessibleName(name);
        applyColours();
    }

    void setAdvice(PathAdvice.Level shown, String first, String rest) {
        boolean sameColours = shown == level && !unknown;
        level = shown;
        unknown = false;
        setTexts(first, rest);
        if (!sameColours) {
            applyColours();
        }
    }

    /** Says in plain colours why there is no advice. */
    void setUnknown(String sentence) {
        unknown = true;
        setTexts(sentence, "");
        applyColours();
    }

    private void setTexts(String first, String rest) {
        headline.setTextIfChanged(first);
        body.setTextIfChanged(rest);
        body.setVisible(!rest.isEmpty());
        getAccessibleContext().setAccessibleDescription(first + (rest.isEmpty() ? "" : ". " + rest));
    }

    /** Takes the colours of other text while another advice is shown and worse, so that this one permits nothing. */
    void giveWayTo(AdvicePanel other) {
        boolean giving = other.isVisible() && other.level.compareTo(level) > 0;
        if (giving != plain) {
            plain = giving;
            applyColours();
        }
    }

    /** Headline and reasons, a line each. */
    String text() {
        return headline.getText() + "\n" + body.getText();
    }

    private boolean isPlain() {
        return plain || unknown;
    }

    private void applyColours() {
        setOpaque(!isPlain());
        setBackground(BACKGROUNDS.get(level));
        headline.setForeground(isPlain() ? Theme.TEXT : TEXTS.get(level));
        body.setForeground(isPlain() ? Theme.TEXT : TEXTS.get(level));
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        if (!isPlain()) {
            g.setColor(new Color(NeedleMarkers.rgb(level)));
            g.fillRect(0, 0, BAR_WIDTH, getHeight());
        }
    }
}
