package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import org.phrenic.ui.widget.Theme;

/** A label whose text wraps. */
public final class WrappingLabel extends JTextArea {
    private final boolean bold;

    private WrappingLabel(String name, Color colour, boolean bold) {
        this.bold = bold;
        setName(name);
        getAccessibleContext().setAccessibleName(name);
        setLineWrap(true);
        setWrapStyleWord(true);
        setEditable(false);
        setFocusable(false);
        setOpaque(false);
        setForeground(colour);
        applyTheme();
    }

    static WrappingLabel normal(String name) {
        return new WrappingLabel(name, Theme.TEXT, false);
    }

    static WrappingLabel secondary(String name) {
        return new WrappingLabel(name, Theme.SECONDARY_TEXT, false);
    }

    static WrappingLabel emphasised(String name) {
        return new WrappingLabel(name, Theme.TEXT, true);
    }

    void setTextIfChanged(String text) {
        if (!text.equals(getText())) {
            setText(text);
        }
    }

    private void applyTheme() {
        setBorder(BorderFactory.createEmptyBorder());
        Font font = new JLabel().getFont();
        setFont(bold ? font.deriveFont(Font.BOLD) : font);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        applyTheme();
    }
}
