package org.phrenic.ui;

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
import org.phrenic.format.AtomicFile;
import org.phrenic.format.CsvWriter;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/**
 * Live curves of the observables: chosen from a list that is legend and readout too, over the last 10, 30 or 60 s or all that is at hand. Dragging zooms into times, which then stand still; a double click follows
 * the present again. What is at hand can be saved as {@code observables.csv} has it, and the chart as a picture. Drawn at most ten times a second.
 */
public final class PlotDock extends JPanel implements Session.Events {
    private static final Set<String> SHOWN_FIRST = Set.of("dome_right_mm", "dome_left_mm", "lung_volume_change_ml");
    private static final long REDRAW_NS = 95_000_000L;
    private static final int PICTURE_SCALE = 2;

    private enum Span {
        TEN("10 s", 10),
        THIRTY("30 s", 30),
        SIXTY("60 s", 60),
        ALL("all", Double.POSITIVE_INFINITY);

        private final String label;
        private final double seconds;

        Span(String label, double seconds) {
            this.label = label;
            this.seconds = seconds;
        }

        @Override
        public String toString() {
            return label;
        }
    }

    private final transient Session session;
    private final transient HistoryFeed feed =
            new HistoryFeed(new SampleRing(Observation.COLUMNS.size() + Curve.MOST_POINTS, History.ROWS));
    private final transient PlotChart chart = new PlotChart();
    private final transient PointTracks points;
    private final PlotPanel panel;
    private final CurveList list;
    private final JComboBox<Span> span = new JComboBox<>(Span.values());
    private final JButton reset = new JButton("Reset zoom");
    private boolean frozen;
    private long drawnNs;

    public PlotDock(Session session) {
        super(new BorderLayout());
        this.session = session;
        points = new PointTracks(session);
        panel = new PlotPanel(chart, time -> readout(), this::freeze, this::follow);
        list = new CurveList(Curve.ofObservables(), SHOWN_FIRST, this::chosen);
        JScrollPane scroll = new JScrollPane(
                list, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(null);
        add(tools(), BorderLayout.NORTH);
        add(panel, BorderLayout.CENTER);
        add(scroll, BorderLayout.EAST);
        chosen();
        readout();
        session.listen(this);
    }

    private JComponent tools() {
        JPanel tools = new JPanel(new MigLayout("insets 4 8 2 8, fillx", "[][]push[][][]"));
        JLabel label = new JLabel("Show the last");
        label.setDisplayedMnemonic('l');
        label.setLabelFor(span);
        span.setToolTipText("Stretch of simulated time that is drawn");
        span.addActionListener(e -> follow());
        reset.setToolTipText("Follow the present again (double click on the plot)");
        reset.setEnabled(false);
        reset.addActionListener(e -> follow());
        JButton csv = new JButton("CSV...");
        csv.setToolTipText("Save all samples at hand with the columns of observables.csv");
        csv.addActionListener(e ->
                Choosers.save(this, "Save samples", "observables.csv").ifPresent(file -> saved(file, this::saveCsv)));
        JButton png = new JButton("PNG...");
        png.setToolTipText("Save the plot as a picture of twice its size");
        png.addActionListener(
                e -> Choosers.save(this, "Save plot", "plot.png").ifPresent(file -> saved(file, this::savePng)));
        tools.add(label);
        tools.add(span);
        tools.add(reset);
        tools.add(csv);
        tools.add(png);
        return tools;
    }

    /** Also plots the displacement of a vertex of a surface, up positive; of more than four points the oldest is let go. */
    public void track(int surface, int vertex) {
        points.pick(surface, vertex).ifPresent(curve -> {
            feed.ring().forget(curve.index());
            list.add(curve, true);
            chosen();
        });
    }

    private void chosen() {
        chart.choose(list.shown());
        draw();
    }

    private void freeze() {
        frozen = true;
        reset.setEnabled(true);
        draw();
    }

    private void follow() {
        frozen = false;
        reset.setEnabled(false);
        draw();
    }

    @Override
    public void onScene(LiveScene scene) {
        feed.restart();
        points.begin(scene);
        follow();
    }

    @Override
    public void onTick(Status status) {
        boolean any = feed.pull(session.live().history());
        points.sample(feed.ring());
        long now = System.nanoTime();
        if (any && isShowing() && now - drawnNs >= REDRAW_NS) {
            drawnNs = now;
            draw();
            readout();
        }
    }

    JFreeChart chart() {
        return chart.chart();
    }

    /** Draws what is at hand. */
    void draw() {
        SampleRing ring = feed.ring();
        if (frozen) {
            chart.show(ring, chart.timeAxis().getLowerBound(), chart.timeAxis().getUpperBound());
            return;
        }
        double last = ring.size() == 0 ? 0 : ring.time(ring.size() - 1);
        double first = ring.size() == 0 ? 0 : ring.time(0);
        double seconds = ((Span) span.getSelectedItem()).seconds;
        double from = Math.max(first, last - seconds);
        double to = Double.isInfinite(seconds) ? Math.max(last, from + 1) : Math.max(last, from + seconds);
        chart.show(ring, from, to);
    }

    @Override
    public void onScrub() {
        panel.mark(scrubbedTime());
        readout();
    }

    /** Time of the recorded frame that is looked at, s; NaN for the present. */
    private double scrubbedTime() {
        return session.scrubbed().isPresent()
                ? session.live().history().frameTime(session.scrubbed().getAsInt())
                : Double.NaN;
    }

    private void readout() {
        SampleRing ring = feed.ring();
        double time = Double.isNaN(panel.cursorTime()) ? scrubbedTime() : panel.cursorTime();
        list.read(ring, Double.isNaN(time) ? ring.size() - 1 : ring.nearest(time));
    }

    private void saved(Path file, Consumer<Path> save) {
        try {
            save.accept(file);
            session.say(Session.Message.Kind.NOTE, "Saved " + file + ".");
        } catch (RuntimeException failure) {
            session.say(Session.Message.Kind.REFUSED, failure.getMessage());
        }
    }

    /** Writes all samples at hand: the columns of {@code observables.csv}, then those of picked points. */
    void saveCsv(Path file) {
        SampleRing ring = feed.ring();
        List<Curve> columns = new ArrayList<>(points.curves());
        Map<String, double[]> table = new LinkedHashMap<>();
        for (int c = 0; c < Observation.COLUMNS.size(); c++) {
            table.put(Observation.COLUMNS.get(c), column(ring, c));
        }
        columns.forEach(curve -> table.put(curve.column(), column(ring, curve.index())));
        CsvWriter.write(file, table, CsvWriter.ALL_DIGITS);
    }

    private static double[] column(SampleRing ring, int column) {
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
                chart.chart().createBufferedImage(PICTURE_SCALE * width, PICTURE_SCALE * height, width, height, null);
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
            chart.theme();
        }
    }
}
