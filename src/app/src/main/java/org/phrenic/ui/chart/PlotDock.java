package org.phrenic.ui.chart;

import java.awt.BorderLayout;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.jfree.chart.JFreeChart;
import org.phrenic.document.CsvWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.FileDialogs;

/**
 * Live curves of the observables: chosen from a list that is legend and readout too, over the last 10, 30 or 60 s or
 * all that is at hand. Dragging zooms into times, which then stand still; a double click follows the present again.
 * What is at hand can be saved as {@code observables.csv} has it, and the chart as a picture. Drawn at most ten times a
 * second.
 */
public final class PlotDock extends JPanel implements Session.Listener {
    private static final Set<String> DEFAULT_CURVES = Set.of("dome_right_mm", "dome_left_mm", "lung_volume_change_ml");
    private static final long MIN_REDRAW_NS = 95_000_000L;
    private static final int PNG_SCALE = 2;

    private enum TimeSpan {
        TEN("10 s", 10),
        THIRTY("30 s", 30),
        SIXTY("60 s", 60),
        ALL("all", Double.POSITIVE_INFINITY);

        private final String label;
        private final double seconds;

        TimeSpan(String label, double seconds) {
            this.label = label;
            this.seconds = seconds;
        }

        @Override
        public String toString() {
            return label;
        }
    }

    private final transient Session session;
    private final transient HistoryReader historyReader =
            new HistoryReader(new SampleRingBuffer(Observation.COLUMNS.size() + PlotCurve.MAX_POINTS, RunHistory.ROWS));
    private final transient PlotChart chart = new PlotChart();
    private final transient PointTracker pointTracker;
    private final PlotPanel panel;
    private final CurveLegend legend;
    private final JComboBox<TimeSpan> timeSpan = new JComboBox<>(TimeSpan.values());
    private final JButton resetZoom = new JButton("Reset zoom");
    private boolean frozen;
    private long drawnNs;

    public PlotDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        pointTracker = new PointTracker(session);
        panel = new PlotPanel(chart, time -> updateReadout(), this::freezeTimeRange, this::followLatest);
        legend = new CurveLegend(PlotCurve.ofObservables(), DEFAULT_CURVES, this::onCurveSelection);
        JScrollPane scroll = new JScrollPane(
                legend,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(null);
        add(toolBar(), BorderLayout.NORTH);
        add(panel, BorderLayout.CENTER);
        add(scroll, BorderLayout.EAST);
        onCurveSelection();
        updateReadout();
        session.addListener(this);
    }

    private JComponent toolBar() {
        JPanel tools = new JPanel(new MigLayout("insets 4 8 2 8, fillx", "[][]push[][][]"));
        JLabel label = new JLabel("Show the last");
        label.setDisplayedMnemonic('l');
        label.setLabelFor(timeSpan);
        timeSpan.setToolTipText("Stretch of simulated time that is drawn");
        timeSpan.addActionListener(e -> followLatest());
        resetZoom.setToolTipText("Follow the present again (double click on the plot)");
        resetZoom.setEnabled(false);
        resetZoom.addActionListener(e -> followLatest());
        JButton csv = new JButton("CSV...");
        csv.setToolTipText("Save all samples at hand with the columns of observables.csv");
        csv.addActionListener(e ->
                FileDialogs.save(this, "Save samples", "observables.csv").ifPresent(file -> save(file, this::saveCsv)));
        JButton png = new JButton("PNG...");
        png.setToolTipText("Save the plot as a picture of twice its size");
        png.addActionListener(
                e -> FileDialogs.save(this, "Save plot", "plot.png").ifPresent(file -> save(file, this::savePng)));
        tools.add(label);
        tools.add(timeSpan);
        tools.add(resetZoom);
        tools.add(csv);
        tools.add(png);
        return tools;
    }

    /**
     * Also plots the displacement of a vertex of a surface, up positive; of more than four points the oldest is let go.
     */
    public void trackPoint(int surface, int vertex) {
        pointTracker.track(surface, vertex).ifPresent(curve -> {
            historyReader.ring().clearColumn(curve.index());
            legend.add(curve, true);
            onCurveSelection();
        });
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
        historyReader.clear();
        pointTracker.reset(scene);
        followLatest();
    }

    @Override
    public void onTick(RunStatus status) {
        boolean any = historyReader.update(session.live().history());
        pointTracker.record(historyReader.ring());
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

    /** Draws what is at hand. */
    public void draw() {
        SampleRingBuffer ring = historyReader.ring();
        if (frozen) {
            chart.update(
                    ring, chart.timeAxis().getLowerBound(), chart.timeAxis().getUpperBound());
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

    /** Time of the recorded frame that is looked at, s; NaN for the present. */
    private double historyFrameTime() {
        return session.historyFrame().isPresent()
                ? session.live().history().frameTime(session.historyFrame().getAsInt())
                : Double.NaN;
    }

    private void updateReadout() {
        SampleRingBuffer ring = historyReader.ring();
        double time = Double.isNaN(panel.cursorTime()) ? historyFrameTime() : panel.cursorTime();
        legend.showValues(ring, Double.isNaN(time) ? ring.size() - 1 : ring.nearest(time));
    }

    private void save(Path file, Consumer<Path> save) {
        try {
            save.accept(file);
            session.note("Saved " + file + ".");
        } catch (RuntimeException failure) {
            session.refuse(failure.getMessage());
        }
    }

    /** Writes all samples at hand: the columns of {@code observables.csv}, then those of picked points. */
    public void saveCsv(Path file) {
        SampleRingBuffer ring = historyReader.ring();
        List<PlotCurve> columns = new ArrayList<>(pointTracker.curves());
        Map<String, double[]> table = new LinkedHashMap<>();
        for (int c = 0; c < Observation.COLUMNS.size(); c++) {
            table.put(Observation.COLUMNS.get(c), column(ring, c));
        }
        columns.forEach(curve -> table.put(curve.column(), column(ring, curve.index())));
        CsvWriter.write(file, table, CsvWriter.ALL_DIGITS);
    }

    private static double[] column(SampleRingBuffer ring, int column) {
        double[] values = new double[ring.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = ring.value(column, i);
        }
        return values;
    }

    private void savePng(Path file) {
        int width = Math.max(panel.getWidth(), 400);
        int height = Math.max(panel.getHeight(), 200);
        BufferedImage picture =
                chart.chart().createBufferedImage(PNG_SCALE * width, PNG_SCALE * height, width, height, null);
        AtomicFile.write(file, out -> {
            if (!ImageIO.write(picture, "png", out)) {
                throw new IOException("no writer of PNG in this Java");
            }
        });
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (chart != null) {
            chart.applyTheme();
        }
    }
}
