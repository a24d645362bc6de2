package org.phrenic.ui.window;

import java.awt.Color;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/** A message over the view, perhaps with a button. It hides by itself, except for one of a divergence. */
public final class MessageBanner extends JPanel {
    private static final int NOTE_DURATION_MS = 6_000;
    private static final int REFUSED_DURATION_MS = 15_000;
    private static final int TEXT_WIDTH = 420;
    private static final int TEXT_WIDTH_WITH_BUTTON = 230;

    private final JLabel text = new JLabel();
    private final JButton actionButton = new JButton("Help");
    private final JButton close = Controls.iconButton(Icons.CLOSE, "Close this message", () -> setVisible(false));
    private final Timer hideTimer = new Timer(NOTE_DURATION_MS, e -> setVisible(false));
    private Session.Message.Kind kind = Session.Message.Kind.NOTE;
    private transient Runnable action = () -> {};

    MessageBanner() {
        super(new MigLayout("insets 8 12 8 8, gap 10", "[grow, fill][][]", "[center]"));
        setName("banner");
        text.setName("banner.text");
        text.getAccessibleContext().setAccessibleName("Message");
        actionButton.setName("banner.help");
        actionButton.setToolTipText("The action that the message offers");
        actionButton.addActionListener(e -> {
            setVisible(false);
            action.run();
        });
        hideTimer.setRepeats(false);
        add(text, "wmin 0");
        add(actionButton, "hidemode 3");
        add(close);
        setVisible(false);
    }

    /** Shows a message without a button. */
    void show(Session.Message message) {
        show(message, Optional.empty(), () -> {});
    }

    /** Shows a message with a button of this text that does {@code whenPressed}. */
    void show(Session.Message message, Optional<String> button, Runnable whenPressed) {
        if (isVisible() && kind == Session.Message.Kind.DIVERGED && message.kind() == Session.Message.Kind.NOTE) {
            return;
        }
        kind = message.kind();
        action = whenPressed;
        int width = button.isPresent() ? TEXT_WIDTH_WITH_BUTTON : TEXT_WIDTH;
        String sentence = Controls.escapeHtml(Controls.capitalise(message.text()));
        text.setText("<html><body width='" + width + "'>" + sentence + "</body></html>");
        text.getAccessibleContext().setAccessibleDescription(message.text());
        button.ifPresent(actionButton::setText);
        actionButton.setVisible(button.isPresent());
        applyColours();
        setVisible(true);
        hideTimer.stop();
        if (kind != Session.Message.Kind.DIVERGED) {
            hideTimer.setInitialDelay(kind == Session.Message.Kind.NOTE ? NOTE_DURATION_MS : REFUSED_DURATION_MS);
            hideTimer.start();
        }
        revalidate();
        repaint();
    }

    /** The message that is shown; empty if none is. */
    public String message() {
        return isVisible() ? text.getAccessibleContext().getAccessibleDescription() : "";
    }

    private void applyColours() {
        switch (kind) {
            case NOTE -> applyColours(Theme.NOTE_BACKGROUND, Theme.NOTE_TEXT);
            case REFUSED -> applyColours(Theme.WARNING_BACKGROUND, Theme.WARNING_TEXT);
            case DIVERGED -> applyColours(Theme.ALARM_BACKGROUND, Theme.ALARM_TEXT);
        }
    }

    private void applyColours(Color background, Color ink) {
        setBackground(background);
        text.setForeground(ink);
        close.setForeground(ink);
        setBorder(BorderFactory.createMatteBorder(0, 3, 0, 0, ink));
    }
}
