package org.phrenic.ui;

import java.awt.event.ActionEvent;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;

/** One sentence over the view, perhaps with a button that helps. What stopped the simulation stays until it is answered; the rest goes by itself. */
final class Banner extends JPanel {
    private static final int NOTE_MS = 6_000;
    private static final int REFUSED_MS = 15_000;
    private static final int TEXT_WIDTH = 420;
    private static final int TEXT_WIDTH_BESIDE_BUTTON = 230;

    private final JLabel text = new JLabel();
    private final JButton help = new JButton("Help");
    private final JButton close = new JButton(Icons.CLOSE);
    private final Timer leave = new Timer(NOTE_MS, e -> setVisible(false));
    private Session.Message.Kind kind = Session.Message.Kind.NOTE;
    private transient Runnable remedy = () -> {};

    Banner() {
        super(new MigLayout("insets 8 12 8 8, gap 10", "[grow, fill][][]", "[center]"));
        setName("banner");
        text.setName("banner.text");
        text.getAccessibleContext().setAccessibleName("Message");
        help.setName("banner.help");
        help.setToolTipText("Does what the message offers");
        help.addActionListener(this::answer);
        close.setToolTipText("Close this message");
        close.getAccessibleContext().setAccessibleName("Close this message");
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.addActionListener(e -> setVisible(false));
        leave.setRepeats(false);
        add(text, "wmin 0");
        add(help, "hidemode 3");
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
        remedy = whenPressed;
        String sentence = message.text().isEmpty()
                ? ""
                : message.text().substring(0, 1).toUpperCase(Locale.ROOT)
                        + message.text().substring(1);
        int width = button.isPresent() ? TEXT_WIDTH_BESIDE_BUTTON : TEXT_WIDTH;
        text.setText("<html><body width='" + width + "'>" + escaped(sentence) + "</body></html>");
        text.getAccessibleContext().setAccessibleDescription(message.text());
        button.ifPresent(help::setText);
        help.setVisible(button.isPresent());
        colour();
        setVisible(true);
        leave.stop();
        if (kind != Session.Message.Kind.DIVERGED) {
            leave.setInitialDelay(kind == Session.Message.Kind.NOTE ? NOTE_MS : REFUSED_MS);
            leave.start();
        }
        revalidate();
        repaint();
    }

    /** The sentence that is shown; empty if none is. */
    String sentence() {
        return isVisible() ? text.getAccessibleContext().getAccessibleDescription() : "";
    }

    private void answer(ActionEvent e) {
        setVisible(false);
        remedy.run();
    }

    private static String escaped(String sentence) {
        return sentence.replace("&", "&amp;").replace("<", "&lt;");
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            colour();
        }
    }

    private void colour() {
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
