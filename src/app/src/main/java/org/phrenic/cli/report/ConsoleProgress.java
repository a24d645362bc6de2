package org.phrenic.cli.report;

import java.io.Console;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.Numbers;
import org.phrenic.fit.FitProgress;
import org.phrenic.patient.ImportProgress;
import org.phrenic.simulation.SimulationRun;

/**
 * Prints progress to stderr, without colours. Continuous progress is one line that is redrawn on a terminal, and a
 * plain line every few seconds otherwise. Counted items are printed one per line.
 */
public class ConsoleProgress
        implements SimulationRun.Progress, ProgressListener, FitProgress, ImportProgress, AutoCloseable {
    private static final int BAR_WIDTH = 30;
    private static final long LINE_INTERVAL_NS = 5_000_000_000L;
    private static final long FIRST_ESTIMATE_NS = 10_000_000_000L;
    private static final long BAR_INTERVAL_NS = 100_000_000L;

    /** On Linux, a link to what stderr is. */
    private static final Path STDERR = Path.of("/proc/self/fd/2");

    private final PrintWriter err;
    private final String counted;
    private final boolean terminal = isTerminal();
    private final long begun = System.nanoTime();
    private long last = begun;
    private boolean drawn;
    /** Items that were done before. */
    private int known;

    /** Progress with the counter label "runs done". */
    public ConsoleProgress(PrintWriter err) {
        this(err, "runs done");
    }

    /** @param counted label of the counter of {@link #done}, such as "cells done" */
    public ConsoleProgress(PrintWriter err, String counted) {
        this.err = err;
        this.counted = counted;
    }

    /** Whether stderr is a terminal that can redraw a line; where the system does not tell, whether stdout is. */
    private static boolean isTerminal() {
        String kind = System.getenv("TERM");
        if (kind == null || kind.equals("dumb")) {
            return false;
        }
        try {
            return Files.readSymbolicLink(STDERR).toString().matches("/dev/(pts|tty).*");
        } catch (IOException | UnsupportedOperationException untold) {
            return isConsole();
        }
    }

    @SuppressWarnings("SystemConsoleNull") // null before Java 22, isTerminal() since then
    private static boolean isConsole() {
        Console console = System.console();
        if (console == null) {
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
        int full = (int) (BAR_WIDTH * Math.min(1, simulatedS / totalS));
        String bar = terminal ? "[" + "#".repeat(full) + " ".repeat(BAR_WIDTH - full) + "] " : "";
        draw(simulatedS >= totalS, bar + "%.2f of %.2f s simulated, %.0f steps/s", simulatedS, totalS, stepsPerS);
    }

    @Override
    public void settling(double doneS, double totalS) {
        draw(false, "settling, %.1f %% done", 100 * doneS / totalS);
    }

    @Override
    public void evaluated(int count, int most, double bestMm, double initialMm) {
        String format = "%d of at most %d breaths, mean distance %.3f mm, %.3f of the initial";
        draw(false, format, count, most, bestMm, bestMm / initialMm);
    }

    private synchronized void draw(boolean complete, String format, Object... figures) {
        long now = System.nanoTime();
        if (now - last < (terminal ? BAR_INTERVAL_NS : LINE_INTERVAL_NS) && !(complete && drawn)) {
            return;
        }
        last = now;
        String line = Numbers.format(format, figures);
        err.print(terminal ? "\r" + line + "  " : line + "\n");
        err.flush();
        drawn = terminal;
    }

    @Override
    public void resumed(int count) {
        known = count;
    }

    @Override
    public void done(int count, int total, String what) {
        String left = timeLeft(System.nanoTime() - begun, count - known, total - known);
        note(count + " of " + total + " " + counted + left + ": " + what);
    }

    /**
     * Estimated time until the last item is done, as the items before took on average; empty in the first ten seconds
     * and after the last item.
     */
    static String timeLeft(long elapsedNs, int count, int total) {
        if (elapsedNs < FIRST_ESTIMATE_NS || count < 1 || count >= total) {
            return "";
        }
        long seconds = Math.round(1e-9 * elapsedNs / count * (total - count));
        return seconds < 90
                ? " (about " + seconds + " s left)"
                : " (about " + Math.round(seconds / 60.0) + " min left)";
    }

    @Override
    public void meshed(int count, int total, String structure) {
        note(count + " of " + total + " structures meshed: " + structure);
    }

    @Override
    public void stage(String what) {
        note(what);
    }

    @Override
    public synchronized void note(String sentence) {
        end();
        err.println(sentence);
        err.flush();
    }

    /** Ends the redrawn line with a line break. */
    public synchronized void end() {
        if (drawn) {
            err.println();
            drawn = false;
        }
    }

    @Override
    public void close() {
        end();
    }
}
