package org.phrenic.ui.chart;

import java.awt.BorderLayout;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.jfree.chart.JFreeChart;
import org.jfree.data.Range;
import org.phrenic.document.CsvWriter;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.export.PngFile;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.FileDialogs;
import org.phrenic.ui.widget.ScrollablePanel;

/**
 * Plots the observables of the last 10, 30 or 60 s, or of all recorded samples, at most ten times per second. Dragging
 * zooms into a time range, which then stays; a double click follows the present again. The last whole breath can be
 * kept and drawn over those that follow.
 */
public final class PlotDock extends JPanel implements Session.Listener {
    private static final Set<String> DEFAULT_CURVES = Set.of("dome_right_mm", "dome_left_mm", "lung_volume_change_ml");
    private static final long MIN_REDRAW_NS = 95_000_000L;
    private static final int PNG_SCALE = 2;
    /** Samples that lie further back than this, s, are those of a run that began anew. */
    private static final double RESTART_S = 0.5;

    private record TimeSpan(String label, double seconds) {
        @Override
        public String toString() {
            return label;
        }
    }

    private static final TimeSpan[] TIME_SPANS = {
        new TimeSpan("10 s", 10),
        new TimeSpan("30 s", 30),
        new TimeSpan("60 s", 60),
        new TimeSpan("all", Double.POSITIVE_INFINITY)
    };

    private final transient Session session;
    private final transient SampleRingBuffer ring =
            new SampleRingBuffer(Observation.COLUMNS.size() + PlotCurve.MAX_POINTS, RunHistory.ROWS);
    private final transient PlotChart chart = new PlotChart();
    private final transient PointTracker pointTracker;
    private final PlotPanel panel;
    private final CurveLegend legend;
    private final JComboBox<TimeSpan> timeSpan = new JComboBox<>(TIME_SPANS);
    private final JButton resetZoom =
            Controls.button("Reset zoom", "Follow the present again (double click on the plot)", this::followLatest);
    private final JLabel overlayLabel = Controls.secondaryLabel("");
    private transient Optional<KeptBreath> overlay = Optional.empty();
    private transient Scenario lastScenario;
    private double changedS;
    private boolean frozen;
    private long drawnNs;

    public PlotDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        pointTracker = new PointTracker(session);
        panel = new PlotPanel(chart, time -> updateReadout(), this::freezeTimeRange, this::followLatest);
        legend = new CurveLegend(PlotCurve.ofObservables(), DEFAULT_CURVES, this::onCurveSelection);
        add(toolBar(), BorderLayout.NORTH);
        add(panel, BorderLayout.CENTER);
        add(ScrollablePanel.scrollPane(legend), BorderLayout.EAST);
        onCurveSelection();
        updateReadout();
        session.addListener(this);
    }

    private JComponent toolBar() {
        JPanel tools = new JPanel(new MigLayout("insets 4 8 2 8, fillx", "[][][grow,fill,0::][][][]"));
        JLabel label = new JLabel("Show the last");
        label.setDisplayedMnemonic('l');
        label.setLabelFor(timeSpan);
        timeSpan.setToolTipText("Range of simulated time that is drawn");
        timeSpan.addActionListener(e -> followLatest());
        resetZoom.setEnabled(false);
        tools.add(label);
        tools.add(timeSpan);
        tools.add(overlayLabel, "wmin 0");
        tools.add(resetZoom);
        tools.add(Controls.button(
                "CSV...",
                "Save all recorded samples with the columns of observables.csv",
                () -> save("Save samples", "observables.csv", this::saveCsv)));
        tools.add(Controls.button(
                "PNG...",
                "Save the plot as a picture of twice its size",
                () -> save("Save plot", "plot.png", this::savePng)));
        return tools;
    }

    /**
     * Plots the displacement of a vertex too, up positive; a fifth point replaces the oldest.
     *
     * @return the label of its curve; empty while there is no scene
     */
    public Optional<String> trackPoint(int surface, int vertex) {
        Optional<PlotCurve> tracked = pointTracker.track(surface, vertex);
        tracked.ifPresent(curve -> {
            ring.clearColumn(curve.index());
            legend.add(curve, true);
            onCurveSelection();
        });
        return tracked.map(PlotCurve::label);
    }

    /**
     * Keeps the last whole breath since the last change of a setting, and draws it over those that follow.
     *
     * @param name settings that it was breathed with
     * @return false if there is no such breath; then the overlay is removed
     */
    public boolean keepBreath(String name) {
        showOverlay(KeptBreath.last(name, ring, changedS));
        return overlay.isPresent();
    }

    public void removeOverlay() {
        showOverlay(Optional.empty());
    }

    private void showOverlay(Optional<KeptBreath> breath) {
        overlay = breath;
        chart.setOverlay(breath.orElse(null));
        overlayLabel.setText(breath.map(kept -> "Thin dashes: " + kept.name()).orElse(""));
        overlayLabel.setToolTipText(overlayLabel.getText());
        draw();
    }

    /** Peak-to-peak values of the curves that are shown, of the kept breath and of the last; empty without one. */
    public Optional<BreathComparison> comparison() {
        return overlay.map(
                kept -> BreathComparison.of(legend.selectedCurves(), kept, KeptBreath.last("", ring, changedS)));
    }

    private void onCurveSelection() {
        chart.setCurves(legend.selectedCurves());
        draw();
    }

    private void freezeTimeRange() {
        frozen = true;
        resetZoom.setEnabled(true);
        draw();
    }

    private void followLatest() {
        frozen = false;
        resetZoom.setEnabled(false);
        draw();
    }

    @Override
    public void onScene(LiveScene scene) {
        ring.clear();
        changedS = 0;
        lastScenario = session.scenario();
        pointTracker.curves().forEach(legend::remove);
        pointTracker.reset(scene);
        chart.setCurves(legend.selectedCurves());
        followLatest();
    }

    @Override
    public void onChange() {
        if (!session.scenario().equals(lastScenario)) {
            lastScenario = session.scenario();
            changedS = session.live().status().timeS();
        }
    }

    @Override
    public void onTick(RunStatus status) {
        boolean any = ring.update(session.live().history());
        if (ring.size() > 0 && ring.time(ring.size() - 1) < changedS - RESTART_S) {
            changedS = 0;
        }
        pointTracker.record(ring);
        long now = System.nanoTime();
        if (any && isShowing() && now - drawnNs >= MIN_REDRAW_NS) {
            drawnNs = now;
            draw();
            updateReadout();
        }
    }

    public JFreeChart chart() {
        return chart.chart();
    }

    public void draw() {
        if (frozen) {
            Range shown = chart.timeAxis().getRange();
            chart.update(ring, shown.getLowerBound(), shown.getUpperBound());
            return;
        }
        double last = ring.size() == 0 ? 0 : ring.time(ring.size() - 1);
        double first = ring.size() == 0 ? 0 : ring.time(0);
        double seconds = ((TimeSpan) timeSpan.getSelectedItem()).seconds;
        double from = Math.max(first, last - seconds);
        double to = Double.isInfinite(seconds) ? Math.max(last, from + 1) : Math.max(last, from + seconds);
        chart.update(ring, from, to);
    }

    @Override
    public void onScrub() {
        panel.setMarkedTime(historyFrameTime());
        updateReadout();
    }

    /** Time of the recorded frame that is shown, s; NaN for the present. */
    private double historyFrameTime() {
        return session.historyFrame().isPresent()
                ? session.live().history().frameTime(session.historyFrame().getAsInt())
                : Double.NaN;
    }

    private void updateReadout() {
        double time = Double.isNaN(panel.cursorTime()) ? historyFrameTime() : panel.cursorTime();
        legend.showValues(ring, Double.isNaN(time) ? ring.size() - 1 : ring.nearest(time));
    }

    private void save(String title, String proposed, Consumer<Path> write) {
        FileDialogs.save(this, title, proposed).ifPresent(file -> {
            try {
                write.accept(file);
                session.note("Saved " + file + ".");
            } catch (RuntimeException failure) {
                session.refuse(failure.getMessage());
            }
        });
    }

    /** Writes all recorded samples: the columns of {@code observables.csv}, then those of picked points. */
    public void saveCsv(Path file) {
        Map<String, double[]> table = new LinkedHashMap<>();
        for (int c = 0; c < Observation.COLUMNS.size(); c++) {
            table.put(Observation.COLUMNS.get(c), ring.column(c));
        }
        pointTracker.curves().forEach(curve -> table.put(curve.column(), ring.column(curve.index())));
        CsvWriter.write(file, table, CsvWriter.ALL_DIGITS);
    }

    private void savePng(Path file) {
        int width = Math.max(panel.getWidth(), 400);
        int height = Math.max(panel.getHeight(), 200);
        PngFile.write(
                file, chart.chart().createBufferedImage(PNG_SCALE * width, PNG_SCALE * height, width, height, null));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (chart != null) {
            chart.applyTheme();
        }
    }
}
