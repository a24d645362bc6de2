package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTextArea;

/** A few sentences that wrap: a label for reading. */
public final class WrappingLabel extends JTextArea {
    private final boolean secondary;
    private final boolean emphasised;

    private WrappingLabel(String name, boolean quiet, boolean bold) {
        this.secondary = quiet;
        this.emphasised = bold;
        setName(name);
        getAccessibleContext().setAccessibleName(name);
        setLineWrap(true);
        setWrapStyleWord(true);
        setEditable(false);
        setFocusable(false);
        setOpaque(false);
        applyTheme();
    }

    /** In the colour of text. */
    public static WrappingLabel normal(String name) {
        return new WrappingLabel(name, false, false);
    }

    /** What matters less. */
    public static WrappingLabel secondary(String name) {
        return new WrappingLabel(name, true, false);
    }

    /** What matters most. */
    public static WrappingLabel emphasised(String name) {
        return new WrappingLabel(name, false, true);
    }

    /** Says something else; nothing happens if it is the same. */
    public void setTextIfChanged(String text) {
        if (!text.equals(getText())) {
            setText(text);
        }
    }

    /** In another colour, until the look changes. */
    void setTextColour(Color ink) {
        setForeground(ink);
    }

    private void applyTheme() {
        setBorder(BorderFactory.createEmptyBorder());
        Font font = new JLabel().getFont();
        setFont(emphasised ? font.deriveFont(Font.BOLD) : font);
        setForeground(secondary ? AdviceColours.secondaryText() : AdviceColours.textColour());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        applyTheme();
    }
}
