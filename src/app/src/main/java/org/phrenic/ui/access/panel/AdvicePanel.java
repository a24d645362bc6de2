package org.phrenic.ui.access.panel;

import java.awt.Graphics;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.plan.PathAdvice;

/** A headline in green, amber or red, and the reasons for it. */
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

    void setAdvice(PathAdvice.Level shown, String first, String rest) {
        headline.setTextIfChanged(first);
        body.setTextIfChanged(rest);
        body.setVisible(!rest.isEmpty());
        if (shown != level) {
            level = shown;
            applyColours();
        }
        getAccessibleContext().setAccessibleName("Path");
        getAccessibleContext().setAccessibleDescription(first + (rest.isEmpty() ? "" : ". " + rest));
    }

    /** Headline and reasons, a line each. */
    String text() {
        return headline.getText() + "\n" + body.getText();
    }

    private void applyColours() {
        setBackground(AdviceColours.background(level));
        headline.setForeground(AdviceColours.text(level));
        body.setForeground(AdviceColours.text(level));
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        g.setColor(AdviceColours.path(level));
        g.fillRect(0, 0, BAR_WIDTH, getHeight());
    }
}
