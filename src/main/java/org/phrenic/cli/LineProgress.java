package org.phrenic.cli;

import java.io.PrintWriter;
import org.phrenic.study.StudyProgress;

/** How far a study is, a line a step. */
final class LineProgress implements StudyProgress {
    private final PrintWriter err;
    private final String done;

    /** Counts runs. */
    LineProgress(PrintWriter err) {
        this(err, "runs done");
    }

    /** @param done what a line counts, such as "cells done" */
    LineProgress(PrintWriter err, String done) {
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
