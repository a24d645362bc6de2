package org.phrenic.ui.dock;

import java.util.Locale;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Theme;

/** A row of a dock for one setting: a label above its controls, and perhaps a message below them. */
abstract class SettingRow extends JPanel {
    /** Slider, number, unit, reset; the number has room for a small one such as 0.001234. */
    private static final String COLUMNS = "[40:80:,grow,fill]6[84!]4[50!]2[20!]";

    private static final Pattern SPACES = Pattern.compile("\\s+");

    private final transient Setting<?> setting;
    private final String searchText;
    private final JLabel label;
    private final JLabel message = new JLabel();
    private String hint = "";
    private boolean hintIsWarning;
    private String inputMessage = "";
    private String tip;

    SettingRow(Setting<?> setting, String details) {
        super(new MigLayout("insets 2 10 3 6, fillx, hidemode 3, gapy 0", COLUMNS));
        this.setting = setting;
        String key = setting.key();
        String words = String.join(" ", setting.label(), key, key.replace('_', ' '), setting.description(), details);
        searchText = words.toLowerCase(Locale.ROOT);
        tip = tip(setting.description(), details);
        label = new JLabel(setting.label());
        label.setToolTipText(tip);
        message.setVisible(false);
        add(label, "wmin 0, growx, spanx, wrap");
        setOpaque(false);
    }

    /** Names the main control and adds the message; called when the controls are added. */
    final void finish(JComponent main) {
        label.setLabelFor(main);
        main.getAccessibleContext().setAccessibleName(setting.label());
        main.setToolTipText(tip);
        add(message, "newline, spanx, growx, wmin 0, gapleft 2");
    }

    /** Sets the details of the tooltip of the label and these controls. */
    final void setDetails(String details, JComponent... controls) {
        String changed = tip(setting.description(), details);
        if (!changed.equals(tip)) {
            tip = changed;
            label.setToolTipText(changed);
            for (JComponent control : controls) {
                control.setToolTipText(changed);
            }
        }
    }

    /** Shows a message on the present state; none if it is empty. A message on the input is shown before it. */
    final void setHint(String sentence, boolean isWarning) {
        hint = sentence;
        hintIsWarning = isWarning;
        showMessage();
    }

    /** Shows a message on what was typed, until an empty one is set. */
    final void setInputMessage(String sentence) {
        inputMessage = sentence;
        showMessage();
    }

    private void showMessage() {
        String sentence = message();
        if (!sentence.isEmpty()) {
            boolean isWarning = !inputMessage.isEmpty() || hintIsWarning;
            message.setForeground(isWarning ? Theme.WARNING_TEXT : Theme.SECONDARY_TEXT);
            message.setText("<html>" + Controls.escapeHtml(sentence) + "</html>");
        }
        if (message.isVisible() == sentence.isEmpty()) {
            message.setVisible(!sentence.isEmpty());
            revalidate();
        }
    }

    /** The message below the controls; empty if there is none. */
    final String message() {
        return inputMessage.isEmpty() ? hint : inputMessage;
    }

    /** A tooltip in lines of readable length, with details in italics. */
    static String tip(String meaning, String details) {
        return "<html><div style='width:240px'>" + Controls.escapeHtml(meaning) + "<br><i>"
                + Controls.escapeHtml(details) + "</i></div></html>";
    }

    /** Whether all words of a search are in its label, key, description or details. */
    final boolean matches(String search) {
        return SPACES.splitAsStream(search.toLowerCase(Locale.ROOT).strip()).allMatch(searchText::contains);
    }

    final String label() {
        return setting.label();
    }

    final boolean isFor(String key) {
        return setting.key().equals(key);
    }

    /** Shows the value of a scenario; input that is not finished stays. */
    abstract void show(Scenario scenario);

    abstract boolean isOffDefault(Scenario scenario);

    /** Whether scenarios of this material use the setting. */
    boolean applies(Scenario scenario) {
        return true;
    }
}
