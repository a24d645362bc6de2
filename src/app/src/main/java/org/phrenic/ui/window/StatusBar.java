package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Font;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.file.Numbers;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Theme;

/** The status bar: the structure clicked last, and time, step and speed of the simulation in fields of fixed width. */
final class StatusBar extends JPanel {
    private static final String QUALITY_TIP = "Resolution of the meshes, and the share of the view's pixels that is"
            + " drawn along each side: on a slow machine the picture becomes coarser before the breath"
            + " becomes slower";

    private static final String SLOW_TIP =
            "Slower than it should be: this machine is busy, or too slow for the resolution;"
                    + " a lower one is faster";

    private static final String REALTIME_TIP = "Simulated time over real time";

    private static final String STEP_TIP = "Time step, and the substeps it is split into";

    private static final String PHASE_TIP =
            "Phase of the breath; repeated: a steady breath is played from its record until a setting changes";

    private static final List<String> IMPORTANCE =
            List.of("phase", "time", "realtime", "quality", "frames", "step", "dt", "steps", "nodes");

    private static final List<String> NUMERICS = List.of("dt", "steps", "step", "nodes");
    private static final int GAP = 10;
    /** Milliseconds of a second. */
    private static final int MS_PER_S = 1000;
    /** Significant digits of the share of the view's pixels that is drawn along each side. */
    private static final int SHARPNESS_DIGITS = 3;
    /** Least width for the structure clicked last, pixels. */
    private static final int PICKED_WIDTH = 180;

    private final transient Map<String, JLabel> fields = new LinkedHashMap<>();
    private final JLabel pickedLabel = new JLabel(" ");
    private String meshes = "";
    private boolean numerics = true;

    StatusBar() {
        super(new MigLayout("insets 3 10 3 10, gap " + GAP + ", novisualpadding, hidemode 3", "[grow, 0::]", "[]"));
        setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Theme.BORDER));
        pickedLabel.setName("pointed");
        pickedLabel.getAccessibleContext().setAccessibleName("Structure and place clicked last");
        add(pickedLabel, "growx, wmin 0");
        addField("quality", QUALITY_TIP, "Medium, drawn at 0.70 sharpness");
        addField("phase", PHASE_TIP, "inspiration, repeated");
        addField("time", "Simulated time", "t 0000.00 s");
        addField("step", "Steps since the start", "step 0 000 000");
        addField("dt", STEP_TIP, "dt 10.000 ms / 10");
        addField("steps", "Steps computed per second", "00 000 steps/s");
        addField("realtime", REALTIME_TIP, "00.00x real time");
        addField("frames", "Frames drawn per second", "000 frames/s");
        addField("nodes", "Nodes that springs move", "000 000 nodes");
    }

    private void addField(String name, String tip, String widest) {
        JLabel label = Controls.describe(Controls.secondaryLabel(" "), tip, tip);
        label.setName("status." + name);
        label.setHorizontalAlignment(JLabel.RIGHT);
        label.setMinimumSize(new JLabel(widest).getPreferredSize());
        fields.put(name, label);
        add(label);
    }

    /** Shows or hides the fields on time steps and nodes. */
    void setNumericsVisible(boolean shown) {
        numerics = shown;
        fit(getWidth());
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        fit(width);
    }

    /** Shows the fields that there is room for beside the structure clicked last, the most important first. */
    private void fit(int width) {
        int room = width == 0 ? Integer.MAX_VALUE : width - UIScale.scale(PICKED_WIDTH);
        for (String name : IMPORTANCE) {
            JLabel field = fields.get(name);
            boolean wanted = numerics || !NUMERICS.contains(name);
            room -= wanted ? field.getMinimumSize().width + UIScale.scale(GAP) : 0;
            field.setVisible(wanted && room >= 0);
        }
    }

    void show(RunStatus s) {
        set("phase", s.phaseLabel() + (s.repeating() ? ", repeated" : ""));
        set("time", time(s.timeS()));
        set("step", "step " + withThousands(s.step()));
        set(
                "dt",
                "dt " + NumberFormats.format(MS_PER_S * s.dtS()) + " ms"
                        + (s.substeps() > 1 ? " / " + s.substeps() : ""));
        set("steps", s.playing() ? withThousands(Math.round(s.stepsPerS())) + " steps/s" : " ");
        set("realtime", s.playing() ? Numbers.format("%.2fx real time", s.realtimeFactor()) : idle(s));
        JLabel dt = fields.get("dt");
        dt.setToolTipText(s.stabilityMessage().isEmpty() ? STEP_TIP : s.stabilityMessage());
        dt.setForeground(s.stabilityMessage().isEmpty() ? Theme.SECONDARY_TEXT : Theme.WARNING_TEXT);
        tell(dt, s.stabilityMessage());
    }

    /** Shows that a recorded moment is looked at while the simulation is paused. */
    void showRecorded(double timeS) {
        set("phase", "recorded");
        set("time", time(timeS));
        set("step", " ");
        set("steps", " ");
        set("realtime", "paused");
    }

    private static String time(double s) {
        return Numbers.format("t %.2f s", s);
    }

    private static String idle(RunStatus s) {
        return s.equals(RunStatus.NOTHING) ? " " : "paused";
    }

    /** Shows whether the simulation keeps the pace that it is asked for. */
    void showPace(boolean behind) {
        JLabel realtime = fields.get("realtime");
        realtime.setForeground(behind ? Theme.WARNING_TEXT : Theme.SECONDARY_TEXT);
        realtime.setToolTipText(behind ? SLOW_TIP : REALTIME_TIP);
        tell(realtime, behind ? SLOW_TIP : "");
    }

    /** @param drawn drawn over shown pixels along each side of the view */
    void showResolution(double drawn) {
        String coarser = drawn < 1 ? ", drawn at " + NumberFormats.format(drawn, SHARPNESS_DIGITS) + " sharpness" : "";
        set("quality", meshes.isEmpty() ? " " : meshes + coarser);
    }

    void show(LiveScene scene) {
        meshes = Controls.capitalise(OrganSettings.meshLabel(scene.scenario()));
        set("nodes", withThousands(scene.nodes()) + " nodes");
    }

    void showFrameRate(double perSecond) {
        set("frames", perSecond < 0.5 ? " " : Numbers.format("%.0f frames/s", perSecond));
    }

    /** Names the structure under the cursor at the last click. */
    void showPicked(String text) {
        pickedLabel.setText(text.isEmpty() ? " " : text);
        Controls.tellValue(pickedLabel, text);
        pickedLabel.setToolTipText(text.isEmpty() ? null : text);
        pickedLabel.setFont(pickedLabel.getFont().deriveFont(text.isEmpty() ? Font.PLAIN : Font.BOLD));
    }

    private void set(String name, String text) {
        JLabel label = fields.get(name);
        if (!label.getText().equals(text)) {
            label.setText(text);
            tell(label, "");
        }
    }

    /** Tells a screen reader what a label shows, and what the colour of a warning means. */
    private static void tell(JLabel label, String warning) {
        String text = label.getText().strip();
        Controls.tellValue(label, warning.isEmpty() ? text : text + ". " + warning);
    }

    private static String withThousands(long value) {
        return Numbers.format("%,d", value).replace(',', ' ');
    }
}
