package org.phrenic.ui.clinic;

import java.awt.Color;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTextArea;

/** A few sentences that wrap: a label for reading. */
public final class Words extends JTextArea {
    private final boolean quiet;
    private final boolean bold;

    private Words(String name, boolean quiet, boolean bold) {
        this.quiet = quiet;
        this.bold = bold;
        setName(name);
        getAccessibleContext().setAccessibleName(name);
        setLineWrap(true);
        setWrapStyleWord(true);
        setEditable(false);
        setFocusable(false);
        setOpaque(false);
        dress();
    }

    /** In the colour of text. */
    public static Words plain(String name) {
        return new Words(name, false, false);
    }

    /** What matters less. */
    public static Words quiet(String name) {
        return new Words(name, true, false);
    }

    /** What matters most. */
    public static Words bold(String name) {
        return new Words(name, false, true);
    }

    /** Says something else; nothing happens if it is the same. */
    public void say(String text) {
        if (!text.equals(getText())) {
            setText(text);
        }
    }

    /** In another colour, until the look changes. */
    void colour(Color ink) {
        setForeground(ink);
    }

    private void dress() {
        setBorder(BorderFactory.createEmptyBorder());
        Font font = new JLabel().getFont();
        setFont(bold ? font.deriveFont(Font.BOLD) : font);
        setForeground(quiet ? Tone.quiet() : Tone.ink());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }
}
