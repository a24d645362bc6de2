package org.phrenic.ui.window;

import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.Theme;

/** Progress of a task beside the running scene, with a button that cancels it. */
final class LoadingPanel extends JPanel {
    private static final int STEPS = 1000;
    /** Lines of the longest sentence, whatever is said. */
    private static final int LINES = 2;
    /** Of the bar, pixels. */
    private static final int WIDTH = 260;

    private final JTextArea what = Dialogs.wrappedText("Loading");
    private final JProgressBar bar = new JProgressBar(0, STEPS);

    /** @param name of the panel; its button is {@code name.cancel} */
    LoadingPanel(String name, String tip, Runnable cancel) {
        super(new MigLayout("insets 8 12 8 12, gap 10 6, novisualpadding", "[0:" + WIDTH + ":" + WIDTH + ", fill][]"));
        setName(name);
        JButton stop = Controls.button("Cancel", tip, () -> {
            setVisible(false);
            cancel.run();
        });
        stop.setName(name + ".cancel");
        bar.getAccessibleContext().setAccessibleName("Progress of loading");
        what.setFocusable(false);
        what.setPreferredSize(
                new Dimension(0, LINES * what.getFontMetrics(what.getFont()).getHeight()));
        add(what, "span 2, growx, wmin 0, hmin 0, wrap");
        add(bar, "growx");
        add(stop);
        setVisible(false);
        setBorder(BorderFactory.createLineBorder(Theme.BORDER));
    }

    /** Shows the progress, and hides the panel at a share of 1. */
    void show(String doing, double share) {
        what.setText(doing.isEmpty() ? "Loading" : Controls.capitalise(doing));
        bar.setValue((int) Math.round(share * STEPS));
        setVisible(share < 1);
    }
}
