package org.phrenic.ui.access.panel;

import java.awt.Graphics;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.PathAdvice;

/** A few words in green, amber or red, with what they rest on. */
public final class AdvicePanel extends JPanel {
    private static final int BAR_WIDTH = 5;

    private final WrappingLabel headline = WrappingLabel.emphasised("Verdict on the path");
    private final WrappingLabel body = WrappingLabel.normal("Reasons and margin");
    private PathAdvice.Level level = PathAdvice.Level.FREE;

    public AdvicePanel() {
        super(new MigLayout("insets 6 13 6 8, gap 0 1, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        add(headline, "wmin 0");
        add(body, "wmin 0");
        applyColours();
    }

    /** Says something. */
    public void setAdvice(PathAdvice.Level how, String first, String rest) {
        headline.setTextIfChanged(first);
        body.setTextIfChanged(rest);
        body.setVisible(!rest.isEmpty());
        if (how != level) {
            level = how;
            applyColours();
        }
        getAccessibleContext().setAccessibleName("Path");
        getAccessibleContext().setAccessibleDescription(first + (rest.isEmpty() ? "" : ". " + rest));
    }

    /** What it says: headline and the rest. */
    public String text() {
        return headline.getText() + "\n" + body.getText();
    }

    /** How it is marked. */
    public PathAdvice.Level level() {
        return level;
    }

    private void applyColours() {
        setBackground(AdviceColours.background(level));
        headline.setTextColour(AdviceColours.text(level));
        body.setTextColour(AdviceColours.text(level));
        repaint();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (headline != null) {
            applyColours();
        }
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        g.setColor(AdviceColours.pathColour(level));
        g.fillRect(0, 0, BAR_WIDTH, getHeight());
    }
}
