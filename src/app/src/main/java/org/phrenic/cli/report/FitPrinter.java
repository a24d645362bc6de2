package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.util.Locale;
import org.phrenic.fit.FitProgress;

/** How far a fit is: a line that is written over itself on a terminal, else one every few seconds. */
public final class FitPrinter implements FitProgress {
    private static final long LINE_EVERY_NS = 5_000_000_000L;

    private final PrintWriter err;
    private final boolean terminal;
    private long last = System.nanoTime();
    private boolean drawn;

    public FitPrinter(PrintWriter err, boolean terminal) {
        this.err = err;
        this.terminal = terminal;
    }

    @Override
    public synchronized void evaluated(int count, int most, double bestMm, double initialMm) {
        long now = System.nanoTime();
        if (!terminal && now - last < LINE_EVERY_NS) {
            return;
        }
        last = now;
        String line = String.format(
                Locale.ROOT,
                "%d of at most %d breaths, mean distance %.3f mm, %.3f of the initial",
                count,
                most,
                bestMm,
                bestMm / initialMm);
        err.print(terminal ? "\r" + line + "  " : line + "\n");
        err.flush();
        drawn = terminal;
    }

    @Override
    public synchronized void note(String sentence) {
        end();
        err.println(sentence);
        err.flush();
    }

    /** Leaves the line that is written over itself. */
    public synchronized void end() {
        if (drawn) {
            err.println();
            drawn = false;
        }
    }
}
