package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.session.SessionMessage;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/**
 * A message over the view, perhaps with a button. It hides by itself, except for one of a divergence, after which
 * others wait their turn.
 */
public final class MessageBanner extends JPanel {
    private static final int NOTE_DURATION_MS = 6_000;
    private static final int REFUSED_DURATION_MS = 15_000;
    private static final int MAX_WIDTH = 620;
    private static final int LEFT = 12;
    private static final int RIGHT = 8;
    private static final int GAP = 10;
    private static final int TEXT_WIDTH = 480;
    private static final int LEAST_TEXT_WIDTH = 80;
    /** Where a line may end within a word: the narrowest space at which a label breaks its text. */
    private static final String BREAK = "\u200a";
    /** What a long word may be broken after: a part of a path, or some letters. */
    private static final Pattern LONG_WORD = Pattern.compile("\\S{1,16}[/\\\\](?=\\S)|\\S{16}(?=\\S)");

    private final JLabel text = new JLabel();
    private final JButton actionButton = new JButton("Help");
    private final JButton close = Controls.iconButton(Icons.CLOSE, "Close this message", this::showNext);
    private final Timer hideTimer = new Timer(NOTE_DURATION_MS, e -> showNext());
    private final transient Deque<SessionMessage> waiting = new ArrayDeque<>();
    private SessionMessage.Kind kind = SessionMessage.Kind.NOTE;
    private transient Runnable action = () -> {};
    private String sentence = "";
    private int textWidth;

    MessageBanner() {
        super(new MigLayout("insets 8 " + LEFT + " 8 " + RIGHT + ", gap " + GAP + " 6", "[grow, fill][]", ""));
        setName("banner");
        text.setName("banner.text");
        text.getAccessibleContext().setAccessibleName("Message");
        actionButton.setName("banner.help");
        actionButton.setToolTipText("The action that the message offers");
        actionButton.addActionListener(e -> {
            Runnable offered = action;
            showNext();
            offered.run();
        });
        hideTimer.setRepeats(false);
        add(text, "wmin 0");
        add(close, "aligny top, wrap");
        add(actionButton, "hidemode 3, span 2, growx 0, wmin 0");
        setVisible(false);
    }

    /** Shows a message without a button. */
    void show(SessionMessage message) {
        show(message, Optional.empty(), () -> {});
    }

    /** Shows a message with a button of this text that does {@code whenPressed}. */
    void show(SessionMessage message, Optional<String> button, Runnable whenPressed) {
        if (showsDivergence() && message.kind() != SessionMessage.Kind.DIVERGED) {
            waiting.add(message);
            return;
        }
        kind = message.kind();
        action = whenPressed;
        sentence = Controls.escapeHtml(
                LONG_WORD.matcher(Controls.capitalise(message.text())).replaceAll("$0" + BREAK));
        textWidth = 0;
        text.getAccessibleContext().setAccessibleDescription(message.text());
        button.ifPresent(actionButton::setText);
        actionButton.setVisible(button.isPresent());
        applyColours();
        fit(MAX_WIDTH);
        setVisible(true);
        hideTimer.stop();
        if (kind != SessionMessage.Kind.DIVERGED) {
            hideTimer.setInitialDelay(kind == SessionMessage.Kind.NOTE ? NOTE_DURATION_MS : REFUSED_DURATION_MS);
            hideTimer.start();
        }
        revalidate();
        repaint();
    }

    private boolean showsDivergence() {
        return isVisible() && kind == SessionMessage.Kind.DIVERGED;
    }

    /** Hides the message of a divergence that is over, if it is shown. */
    void endDivergence() {
        if (showsDivergence()) {
            showNext();
        }
    }

    /** Hides the message, and shows the one that has waited longest. */
    private void showNext() {
        setVisible(false);
        hideTimer.stop();
        if (!waiting.isEmpty()) {
            show(waiting.remove());
        }
    }

    /** Wraps the message so that the banner is at most so wide, pixels. */
    void fit(int room) {
        int around = getInsets().left
                + getInsets().right
                + close.getPreferredSize().width
                + UIScale.scale(LEFT + GAP + RIGHT);
        int width = Math.max(LEAST_TEXT_WIDTH, Math.min(TEXT_WIDTH, Math.min(room, MAX_WIDTH) - around));
        if (width != textWidth) {
            textWidth = width;
            text.setText("<html><body width='" + width + "'>" + sentence + "</body></html>");
        }
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
