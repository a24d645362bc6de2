package org.phrenic.ui.chart;

import java.awt.Dimension;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.widget.ScrollablePanel;
import org.phrenic.ui.widget.Swatch;

/** Legend of the curves, where they are selected and their values are shown. */
final class CurveLegend extends ScrollablePanel {
    private static final int SWATCH_WIDTH = 22;
    private static final int SWATCH_HEIGHT = 10;

    private final transient Map<PlotCurve, CurveRow> rows = new LinkedHashMap<>();
    private final transient Runnable onSelection;
    private final JLabel time = new JLabel("", SwingConstants.RIGHT);

    private record CurveRow(JLabel swatch, JCheckBox box, JLabel value) {}

    /** @param onSelection runs when other curves are selected */
    CurveLegend(List<PlotCurve> curves, Set<String> shown, Runnable onSelection) {
        super(new MigLayout("insets 4 6 4 8, gapy 2, fillx, hidemode 3", "[][grow,fill][right,84!]"));
        this.onSelection = onSelection;
        JLabel at = new JLabel("At time");
        at.setToolTipText("Time of the values: that under the mouse, else that of the timeline");
        add(at, "span 2");
        add(time, "wrap");
        curves.forEach(curve -> add(curve, shown.contains(curve.column())));
    }

    /** Adds a curve; of one that is listed, ticks the box or not. */
    void add(PlotCurve curve, boolean show) {
        CurveRow listed = rows.get(curve);
        if (listed != null) {
            listed.box.setSelected(show);
            return;
        }
        JCheckBox box = new JCheckBox(curve.label(), show);
        String tip = curve.column() + ": " + curve.meaning() + NumberFormats.unitSuffix(curve.unit());
        box.setToolTipText(tip);
        box.addActionListener(e -> onSelection.run());
        JLabel swatch = new JLabel(swatch(curve));
        swatch.setToolTipText(tip);
        JLabel value = new JLabel("", SwingConstants.RIGHT);
        rows.put(curve, new CurveRow(swatch, box, value));
        add(swatch);
        add(box);
        add(value, "wrap");
        revalidate();
    }

    /** Removes a curve, if it is listed. */
    void remove(PlotCurve curve) {
        CurveRow row = rows.remove(curve);
        if (row != null) {
            List.of(row.swatch, row.box, row.value).forEach(this::remove);
            revalidate();
            repaint();
        }
    }

    List<PlotCurve> selectedCurves() {
        return rows.entrySet().stream()
                .filter(row -> row.getValue().box.isSelected())
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Shows the values of a sample; -1 for none. */
    void showValues(SampleRingBuffer ring, int sample) {
        time.setText(sample < 0 ? "-" : NumberFormats.fixedDecimals(ring.time(sample), 2) + " s");
        rows.forEach((curve, row) -> {
            double value = sample < 0 ? Double.NaN : ring.value(curve.index(), sample);
            String text = NumberFormats.fixedDecimals(value, curve.decimals());
            row.value.setText(Double.isNaN(value) ? "-" : text + NumberFormats.unitSuffix(curve.unit()));
        });
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        // Leaves room for the scroll bar beside the values.
        Dimension size = super.getPreferredScrollableViewportSize();
        return new Dimension(size.width + UIManager.getInt("ScrollBar.width"), size.height);
    }

    private static Swatch swatch(PlotCurve curve) {
        return new Swatch(SWATCH_WIDTH, SWATCH_HEIGHT, g -> {
            g.setColor(curve.colour());
            g.setStroke(PlotChart.stroke(curve));
            g.drawLine(2, SWATCH_HEIGHT / 2, SWATCH_WIDTH - 2, SWATCH_HEIGHT / 2);
        });
    }
}
