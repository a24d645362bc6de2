package org.phrenic.ui.dock;

import java.util.Locale;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.widget.Theme;

/**
 * A row of a dock: a label above its controls, and below them, when there is something to say, a sentence. All rows
 * share one set of columns.
 */
abstract class SettingRow extends JPanel {
    /** How much a sentence matters. */
    enum Hint {
        NOTE,
        WARNING
    }

    private static final String COLUMNS = "[40:80:,grow,fill]6[60!]4[50!]2[20!]";

    private static final Pattern SPACES = Pattern.compile("\\s+");

    private final String key;
    private final String words;
    private final JLabel label;
    private final JLabel hint = new JLabel();
    private String condition = "";
    private Hint conditionKind = Hint.NOTE;
    private String answer = "";
    private String tip;

    /**
     * @param key of the scenario
     * @param name for people
     * @param tip what it is, as HTML
     */
    SettingRow(String key, String name, String tip) {
        super(new MigLayout("insets 2 10 3 6, fillx, hidemode 3, gapy 0", COLUMNS));
        this.key = key;
        this.tip = tip;
        words = (name + " " + key + " " + key.replace('_', ' ') + " " + tip.replaceAll("<[^>]*>", " "))
                .toLowerCase(Locale.ROOT);
        label = new JLabel(name);
        label.setToolTipText(tip);
        hint.setVisible(false);
        add(label, "wmin 0, growx, spanx, wrap");
        setOpaque(false);
    }

    /** Puts the sentence below the controls; to be called when they are in place. */
    final void finish(JComponent main, String accessibleName) {
        label.setLabelFor(main);
        main.getAccessibleContext().setAccessibleName(accessibleName);
        main.setToolTipText(tip);
        add(hint, "newline, spanx, growx, wmin 0, gapleft 2");
    }

    /** Text of tooltips from here on. */
    final void setTip(String newTip, JComponent... controls) {
        if (!newTip.equals(tip)) {
            tip = newTip;
            label.setToolTipText(newTip);
            for (JComponent control : controls) {
                control.setToolTipText(newTip);
            }
        }
    }

    /** Says below the controls what holds at present; nothing for an empty sentence. An answer stands before it. */
    final void hint(Hint kind, String sentence) {
        condition = sentence;
        conditionKind = kind;
        showHint();
    }

    /**
     * Says below the controls what became of what was typed; it stays until it is taken back with an empty sentence,
     * whatever else there is to say.
     */
    final void answer(String sentence) {
        answer = sentence;
        showHint();
    }

    private void showHint() {
        String sentence = answer.isEmpty() ? condition : answer;
        if (!sentence.isEmpty()) {
            boolean warning = !answer.isEmpty() || conditionKind == Hint.WARNING;
            hint.setForeground(warning ? Theme.WARNING_TEXT : Theme.SECONDARY_TEXT);
            hint.setText("<html>" + escaped(sentence) + "</html>");
        }
        if (hint.isVisible() == sentence.isEmpty()) {
            hint.setVisible(!sentence.isEmpty());
            revalidate();
        }
    }

    /** The sentence below the controls; empty if there is none. */
    final String hintText() {
        return hint.isVisible() ? hint.getText().replaceAll("<[^>]*>", "") : "";
    }

    static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;");
    }

    /** A tooltip: what it is in lines of readable length, then the details in another line. */
    static String tip(String meaning, String details) {
        return "<html><div style='width:240px'>" + escaped(meaning) + "<br><i>" + escaped(details)
                + "</i></div></html>";
    }

    /** Whether a search finds it: all words of the search are in its name, key or meaning. */
    final boolean matches(String search) {
        return SPACES.splitAsStream(search.toLowerCase(Locale.ROOT).strip()).allMatch(words::contains);
    }

    /** Shows what the scenario has; the user's own unfinished input stays. */
    abstract void show(Scenario scenario);

    /** Whether it is the row of this key. */
    final boolean isFor(String other) {
        return key.equals(other);
    }

    /** Whether the scenario has another value than by default. */
    abstract boolean isOffDefault(Scenario scenario);

    /** Whether scenarios of this kind have it at all. */
    abstract boolean applies(Scenario scenario);
}
