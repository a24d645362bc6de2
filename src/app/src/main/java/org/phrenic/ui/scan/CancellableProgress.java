package org.phrenic.ui.scan;

import java.util.concurrent.CancellationException;
import javax.swing.SwingUtilities;
import org.phrenic.patient.ImportProgress;
import org.phrenic.scene.style.StructureLabels;

/**
 * Reports the progress of an import on the event dispatch thread. After {@link #cancel} the next report throws a
 * {@link CancellationException}, which ends the import before anything is written.
 */
final class CancellableProgress implements ImportProgress {
    /** Receives a stage and the completed share, 0 to 1. */
    interface Display {
        void show(String stage, double share);
    }

    /** Share of an import before and after the meshing of structures. */
    private static final double MESHING_BEGINS = 0.1;

    private static final double MESHING_ENDS = 0.7;

    private final Display display;
    private volatile double share;
    private volatile boolean cancelled;
    private boolean writing;

    CancellableProgress(Display display) {
        this.display = display;
    }

    /** Cancels the import; false where its writing has begun, which goes on. */
    synchronized boolean cancel() {
        cancelled = true;
        return !writing;
    }

    /** From here on the import is written, also if it is cancelled. */
    synchronized void beginWriting() {
        stage("writing the thorax folder");
        writing = true;
    }

    @Override
    public void stage(String what) {
        report(what, share);
    }

    @Override
    public void meshed(int count, int total, String structure) {
        report(
                "meshing: " + StructureLabels.of(structure),
                MESHING_BEGINS + (MESHING_ENDS - MESHING_BEGINS) * count / total);
    }

    private void report(String what, double done) {
        if (cancelled) {
            throw new CancellationException("the import was cancelled");
        }
        share = done;
        SwingUtilities.invokeLater(() -> {
            if (!cancelled) {
                display.show(what, done);
            }
        });
    }
}
