package org.phrenic.ui.clinic;

import java.awt.Graphics;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.rehearsal.PathAdvice;

/** A few words in green, amber or red, with what they rest on. */
public final class Verdict extends JPanel {
    private static final int BAR = 5;

    private final Words headline = Words.bold("Verdict on the path");
    private final Words body = Words.plain("Reasons and margin");
    private PathAdvice.Level level = PathAdvice.Level.FREE;

    public Verdict() {
        super(new MigLayout("insets 6 13 6 8, gap 0 1, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        add(headline, "wmin 0");
        add(body, "wmin 0");
        dress();
    }

    /** Says something. */
    public void say(PathAdvice.Level how, String first, String rest) {
        headline.say(first);
        body.say(rest);
        body.setVisible(!rest.isEmpty());
        if (how != level) {
            level = how;
            dress();
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

    private void dress() {
        setBackground(Tone.background(level));
        headline.colour(Tone.text(level));
        body.colour(Tone.text(level));
        repaint();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (headline != null) {
            dress();
        }
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        g.setColor(Tone.mark(level));
        g.fillRect(0, 0, BAR, getHeight());
    }
}
