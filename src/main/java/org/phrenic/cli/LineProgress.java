package org.phrenic.cli;

import java.io.PrintWriter;
import org.phrenic.study.StudyProgress;

/** How far a study is, a line a run. */
final class LineProgress implements StudyProgress {
    private final PrintWriter err;

    LineProgress(PrintWriter err) {
        this.err = err;
    }

    @Override
    public void done(int count, int total, String what) {
        err.println(count + " of " + total + " runs done: " + what);
        err.flush();
    }

    @Override
    public void note(String sentence) {
        err.println(sentence);
        err.flush();
    }
}
