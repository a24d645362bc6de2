package org.phrenic.ui.window;

import java.awt.event.ActionEvent;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;

/**
 * One sentence over the view, perhaps with a button that helps. What stopped the simulation stays until it is answered;
 * the rest goes by itself.
 */
public final class MessageBanner extends JPanel {
    private static final int NOTE_DURATION_MS = 6_000;
    private static final int REFUSED_DURATION_MS = 15_000;
    private static final int TEXT_WIDTH = 420;
    private static final int TEXT_WIDTH_WITH_BUTTON = 230;

    private final JLabel text = new JLabel();
    private final JButton actionButton = new JButton("Help");
    private final JButton close = new JButton(Icons.CLOSE);
    private final Timer hideTimer = new Timer(NOTE_DURATION_MS, e -> setVisible(false));
    private Session.Message.Kind kind = Session.Message.Kind.NOTE;
    private transient Runnable action = () -> {};

    MessageBanner() {
        super(new MigLayout("insets 8 12 8 8, gap 10", "[grow, fill][][]", "[center]"));
        setName("banner");
        text.setName("banner.text");
        text.getAccessibleContext().setAccessibleName("Message");
        actionButton.setName("banner.help");
        actionButton.setToolTipText("Does what the message offers");
        actionButton.addActionListener(this::onAction);
        close.setToolTipText("Close this message");
        close.getAccessibleContext().setAccessibleName("Close this message");
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.addActionListener(e -> setVisible(false));
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

    /** Shows a message, with a button of this text that does {@code whenPressed}. */
    void show(Session.Message message, Optional<String> button, Runnable whenPressed) {
        boolean keep =
                isVisible() && kind == Session.Message.Kind.DIVERGED && message.kind() == Session.Message.Kind.NOTE;
        if (keep) {
            return;
        }
        kind = message.kind();
        action = whenPressed;
        String sentence = message.text().isEmpty()
                ? ""
                : message.text().substring(0, 1).toUpperCase(Locale.ROOT)
                        + message.text().substring(1);
        int width = button.isPresent() ? TEXT_WIDTH_WITH_BUTTON : TEXT_WIDTH;
        text.setText("<html><body width='" + width + "'>" + escaped(sentence) + "</body></html>");
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

    /** The sentence that is shown; empty if none is. */
    public String message() {
        return isVisible() ? text.getAccessibleContext().getAccessibleDescription() : "";
    }

    private void onAction(ActionEvent e) {
        setVisible(false);
        action.run();
    }

    private static String escaped(String sentence) {
        return sentence.replace("&", "&amp;").replace("<", "&lt;");
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            applyColours();
        }
    }

    private void applyColours() {
        setBackground(
                switch (kind) {
                    case NOTE -> Theme.noteBackground();
                    case REFUSED -> Theme.warningBackground();
                    case DIVERGED -> Theme.alarmBackground();
                });
        text.setForeground(
                switch (kind) {
                    case NOTE -> Theme.noteText();
                    case REFUSED -> Theme.warningText();
                    case DIVERGED -> Theme.alarmText();
                });
        close.setForeground(text.getForeground());
        setBorder(BorderFactory.createMatteBorder(0, 3, 0, 0, text.getForeground()));
    }
}
