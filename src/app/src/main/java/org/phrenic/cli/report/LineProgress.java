package org.phrenic.cli.report;

import java.io.PrintWriter;
import org.phrenic.engine.parallel.ProgressListener;

/** How far a study is, a line a step. */
public final class LineProgress implements ProgressListener {
    private final PrintWriter err;
    private final String done;

    /** Counts runs. */
    public LineProgress(PrintWriter err) {
        this(err, "runs done");
    }

    /** @param done what a line counts, such as "cells done" */
    public LineProgress(PrintWriter err, String done) {
        this.err = err;
        this.done = done;
    }

    @Override
    public void done(int count, int total, String what) {
        note(count + " of " + total + " " + done + ": " + what);
    }

    @Override
    public void note(String sentence) {
        err.println(sentence);
        err.flush();
    }
}
