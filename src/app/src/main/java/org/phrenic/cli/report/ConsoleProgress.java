package org.phrenic.cli.report;

import java.io.Console;
import java.io.PrintWriter;
import java.util.Locale;
import org.phrenic.simulation.SimulationRun;

/** How far a run is: a bar that is drawn over itself on a terminal, else a plain line every few seconds. No colours. */
public final class ConsoleProgress implements SimulationRun.Progress {
    private static final int BAR_WIDTH = 30;
    private static final long LINE_INTERVAL_NS = 5_000_000_000L;
    private static final long BAR_INTERVAL_NS = 100_000_000L;

    private final PrintWriter err;
    private final boolean terminal;
    private long last = System.nanoTime();
    private boolean drawn;

    public ConsoleProgress(PrintWriter err, boolean terminal) {
        this.err = err;
        this.terminal = terminal;
    }

    /** Whether someone looks at a terminal that can draw over a line. */
    @SuppressWarnings("SystemConsoleNull")
    public // null before Java 22, asked from there on
    static boolean isTerminal() {
        Console console = System.console();
        String kind = System.getenv("TERM");
        if (console == null || kind == null || kind.equals("dumb")) {
            return false;
        }
        try {
            return (boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (NoSuchMethodException before22) {
            return true;
        } catch (ReflectiveOperationException unknown) {
            return false;
        }
    }

    @Override
    public void advanced(double simulatedS, double totalS, double stepsPerS) {
        long now = System.nanoTime();
        boolean over = simulatedS >= totalS;
        if (now - last < (terminal ? BAR_INTERVAL_NS : LINE_INTERVAL_NS) && !(over && drawn)) {
            return;
        }
        last = now;
        double share = Math.min(1, simulatedS / totalS);
        String figures =
                String.format(Locale.ROOT, "%.2f of %.2f s simulated, %.0f steps/s", simulatedS, totalS, stepsPerS);
        if (terminal) {
            int full = (int) (BAR_WIDTH * share);
            err.print("\r[" + "#".repeat(full) + " ".repeat(BAR_WIDTH - full) + "] " + figures + "  ");
            drawn = true;
        } else {
            err.print(figures + "\n");
        }
        err.flush();
    }

    @Override
    public void note(String sentence) {
        end();
        err.println(sentence);
    }

    /** Leaves the line on which the bar stands. */
    public void end() {
        if (drawn) {
            err.println();
            drawn = false;
        }
    }
}
