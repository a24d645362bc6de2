package org.phrenic.ui;

import java.awt.Font;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/** The line at the foot of the window: what was pointed at, and how far and how fast the simulation is. Always there; numbers keep their places. */
final class StatusLine extends JPanel {
    private final transient Map<String, JLabel> figures = new LinkedHashMap<>();
    private final JLabel pointed = new JLabel(" ");

    StatusLine() {
        super(new MigLayout("insets 3 10 3 10, gap 14, novisualpadding, hidemode 3", "[grow, 0::]", "[]"));
        setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Theme.line()));
        pointed.setName("pointed");
        pointed.getAccessibleContext().setAccessibleName("Structure and place pointed at");
        add(pointed, "growx, wmin 0");
        figure("phase", "Phase of the breath", "post-expiratory");
        figure("time", "Simulated time", "t 0000.00 s");
        figure("step", "Steps since the start", "step 0 000 000");
        figure("dt", "Time step, and the substeps it is split into", "dt 10.000 ms / 10");
        figure("steps", "Steps computed a second", "00 000 steps/s");
        figure("realtime", "Simulated time over real time", "00.00x real time");
        figure("frames", "Pictures drawn a second", "000 frames/s");
        figure("nodes", "Nodes that springs move", "000 000 nodes");
        for (String physics : new String[] {"dt", "steps", "step", "nodes"}) {
            figures.get(physics).putClientProperty("physics", true);
        }
    }

    private void figure(String name, String tip, String widest) {
        JLabel label = new JLabel(" ");
        label.setName("status." + name);
        label.setToolTipText(tip);
        label.getAccessibleContext().setAccessibleName(tip);
        label.setForeground(Theme.quietText());
        label.setHorizontalAlignment(JLabel.RIGHT);
        label.setMinimumSize(new JLabel(widest).getPreferredSize());
        figures.put(name, label);
        add(label);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Theme.line()));
        if (figures != null) {
            figures.values().forEach(label -> label.setForeground(Theme.quietText()));
        }
    }

    /** Shows the figures of the physics, or leaves them out. */
    void setPhysics(boolean shown) {
        figures.values().stream()
                .filter(label -> label.getClientProperty("physics") != null)
                .forEach(label -> label.setVisible(shown));
    }

    void show(Status s) {
        set("phase", s.phaseLabel());
        set("time", String.format(Locale.ROOT, "t %.2f s", s.timeS()));
        set("step", "step " + grouped(s.step()));
        set(
                "dt",
                String.format(Locale.ROOT, "dt %s ms", plain(1000 * s.dtS()))
                        + (s.substeps() > 1 ? " / " + s.substeps() : ""));
        set("steps", grouped(Math.round(s.stepsPerS())) + " steps/s");
        set("realtime", String.format(Locale.ROOT, "%.2fx real time", s.realtimeFactor()));
        JLabel dt = figures.get("dt");
        dt.setToolTipText(s.limitSentence().isEmpty() ? "Time step" : s.limitSentence());
        dt.setForeground(s.limitSentence().isEmpty() ? Theme.quietText() : Theme.warningText());
    }

    void show(LiveScene scene) {
        set("nodes", grouped(scene.nodes()) + " nodes");
    }

    void showFrames(double perSecond) {
        set("frames", String.format(Locale.ROOT, "%.0f frames/s", perSecond));
    }

    /** What was pointed at. */
    void point(String text) {
        pointed.setText(text.isEmpty() ? " " : text);
        pointed.setFont(pointed.getFont().deriveFont(text.isEmpty() ? Font.PLAIN : Font.BOLD));
    }

    private void set(String name, String text) {
        JLabel label = figures.get(name);
        if (!label.getText().equals(text)) {
            label.setText(text);
        }
    }

    private static String plain(double value) {
        String text = String.format(Locale.ROOT, "%.3f", value);
        return text.replaceFirst("\\.?0+$", "");
    }

    private static String grouped(long value) {
        return String.format(Locale.ROOT, "%,d", value).replace(',', ' ');
    }
}
