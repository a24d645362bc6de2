package org.phrenic.cli;

import org.phrenic.cli.report.ExitCode;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;

/** Whether this machine draws, as a context of its own says. */
final class DrawingHere {
    private DrawingHere() {}

    /** The exit code of a command that draws: success where a context can be opened. */
    static int exitCode() {
        try (OffscreenContext gl = OffscreenContext.open()) {
            return gl.info().description().isEmpty() ? ExitCode.NO_GRAPHICS : ExitCode.SUCCESS;
        } catch (NoGraphicsException none) {
            return ExitCode.NO_GRAPHICS;
        }
    }
}
