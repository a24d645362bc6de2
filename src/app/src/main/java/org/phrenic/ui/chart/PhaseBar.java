package org.phrenic.ui.chart;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import javax.accessibility.AccessibleRole;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.widget.PaintedComponent;

/**
 * Inspiration, expiration and pause as bands of their durations, with a cursor at the present phase. A breath hold
 * fills the bar, and so does every phase of a pattern of other phases.
 */
public final class PhaseBar extends PaintedComponent {
    private static final int HEIGHT = 30;
    private static final int ARC = 8;
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");
    private static final List<String> THREE_PHASE_PRESETS =
            List.of("quiet", "quiet-supine", "deep", "sniff", "rapid-shallow");

    private double inspiration = 0.4;
    private double pause = 0.15;
    private double phase;
    private RespiratoryPhase label = RespiratoryPhase.PAUSE;
    private boolean threePhases = true;

    public PhaseBar() {
        super(AccessibleRole.PROGRESS_BAR, "Phase of the breath");
        setToolTipText("Present phase of the breath");
    }

    public void setPattern(Scenario scenario) {
        inspiration = scenario.get(Breathing.INSPIRATORY_FRACTION);
        pause = scenario.breathing().parameters().pauseFraction();
        threePhases = scenario.trace().isEmpty() && THREE_PHASE_PRESETS.contains(scenario.preset());
        repaint();
    }

    /**
     * Moves the cursor to a sample.
     *
     * @param values observables of the sample
     */
    public void setPhase(double[] values, RunStatus status) {
        phase = values[PHASE];
        RespiratoryPhase current = PhaseColours.parseLabel(status.phaseLabel());
        if (label != current) {
            label = current;
            getAccessibleContext().setAccessibleDescription(PhaseColours.displayName(current));
        }
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return UIScale.scale(new Dimension(200, HEIGHT));
    }

    @Override
    public Dimension getMinimumSize() {
        return UIScale.scale(new Dimension(60, HEIGHT));
    }

    @Override
    protected void paintContent(Graphics2D g) {
        int w = getWidth();
        g.clip(new RoundRectangle2D.Double(0, 0, w, getHeight(), ARC, ARC));
        if (!threePhases || label == RespiratoryPhase.HOLD) {
            paintBand(g, 0, w, label);
        } else {
            double in = inspiration * w;
            double out = (1 - pause) * w;
            paintBand(g, 0, in, RespiratoryPhase.INSPIRATION);
            paintBand(g, in, out, RespiratoryPhase.EXPIRATION);
            paintBand(g, out, w, RespiratoryPhase.PAUSE);
        }
        paintCursor(g, phase * w);
    }

    private void paintBand(Graphics2D g, double from, double to, RespiratoryPhase what) {
        PhaseColours.paintBand(g, new Rectangle2D.Double(from, 0, to - from, getHeight()), what, what == label);
    }

    private void paintCursor(Graphics2D g, double x) {
        g.setColor(PhaseColours.TEXT);
        g.fill(new Rectangle2D.Double(x - 1, 0, 2, getHeight()));
        Path2D tip = new Path2D.Double();
        tip.moveTo(x - 5, 0);
        tip.lineTo(x + 5, 0);
        tip.lineTo(x, 6);
        tip.closePath();
        g.fill(tip);
    }
}
