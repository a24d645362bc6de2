package org.phrenic.ui.access.panel;

import java.awt.Color;
import java.awt.Font;
import java.util.regex.Pattern;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;
import org.phrenic.ui.widget.Theme;

/** A label whose text wraps, but not between a number and its unit. */
public final class WrappingLabel extends JTextArea {
    private static final String NO_BREAK = "\u00a0";
    private static final Pattern KEPT_TOGETHER =
            Pattern.compile("(?<=[0-9]) (?=(?:mm|cm|ml|s|N|%)(?![a-zA-Z]))|(?<=\\brib) (?=[0-9])");

    private static final String PLAIN = "";
    private static final String BOLD = "bold";
    private static final String SMALL = "small";

    private final String styleClass;

    private WrappingLabel(String name, Color colour, String styleClass) {
        this.styleClass = styleClass;
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
        return new WrappingLabel(name, Theme.TEXT, PLAIN);
    }

    static WrappingLabel secondary(String name) {
        return new WrappingLabel(name, Theme.SECONDARY_TEXT, PLAIN);
    }

    /** A note in small letters. */
    static WrappingLabel small(String name) {
        return new WrappingLabel(name, Theme.TEXT, SMALL);
    }

    static WrappingLabel emphasised(String name) {
        return new WrappingLabel(name, Theme.TEXT, BOLD);
    }

    void setTextIfChanged(String text) {
        if (!text.equals(getText())) {
            setText(KEPT_TOGETHER.matcher(text).replaceAll(NO_BREAK));
        }
    }

    @Override
    public String getText() {
        return super.getText().replace(NO_BREAK, " ");
    }

    private void applyTheme() {
        setBorder(BorderFactory.createEmptyBorder());
        JLabel label = new JLabel();
        label.putClientProperty("FlatLaf.styleClass", styleClass);
        Font font = label.getFont();
        setFont(BOLD.equals(styleClass) ? font.deriveFont(Font.BOLD) : font);
        // A text that changes does not scroll what it lies in to its end.
        if (getCaret() instanceof DefaultCaret caret) {
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        applyTheme();
    }
}
