package org.phrenic.ui.window;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.widget.Theme;

/** How far a scene is loaded, and a way out; what ran before goes on behind it. */
final class LoadingPanel extends JPanel {
    private static final int STEPS = 1000;

    private final JLabel what = new JLabel("Loading");
    private final JProgressBar bar = new JProgressBar(0, STEPS);

    LoadingPanel(Runnable cancel) {
        super(new MigLayout("insets 8 12 8 12, gap 10, novisualpadding", "[180!][140!][]", "[center]"));
        setName("loading");
        JButton stop = new JButton("Cancel");
        stop.setName("loading.cancel");
        stop.setToolTipText("Keep what is there");
        stop.addActionListener(e -> {
            setVisible(false);
            cancel.run();
        });
        bar.getAccessibleContext().setAccessibleName("Progress of loading");
        add(what);
        add(bar, "growx");
        add(stop);
        setVisible(false);
        setBorder(BorderFactory.createLineBorder(Theme.borderColour()));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(BorderFactory.createLineBorder(Theme.borderColour()));
    }

    /** Shows it until all is done. */
    void show(String doing, double share) {
        what.setText(doing.isEmpty() ? "Loading" : Character.toUpperCase(doing.charAt(0)) + doing.substring(1));
        bar.setValue((int) Math.round(share * STEPS));
        setVisible(share < 1);
    }
}
