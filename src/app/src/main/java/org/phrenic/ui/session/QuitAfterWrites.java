package org.phrenic.ui.session;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Ends a window once what is being written is whole; asked again meanwhile, at once. On the event dispatch thread. */
public final class QuitAfterWrites {
    private final Consumer<String> say;
    private final BooleanSupplier mayLose;
    private final Runnable end;
    private boolean waiting;
    private boolean ended;

    /**
     * @param say tells the user what is waited for
     * @param mayLose asks about what the end of the window would lose; true to end it
     * @param end ends the window; called once
     */
    public QuitAfterWrites(Consumer<String> say, BooleanSupplier mayLose, Runnable end) {
        this.say = say;
        this.mayLose = mayLose;
        this.end = end;
    }

    /** Ends the window; where that loses something, it is asked first. */
    public void quit() {
        if (waiting || mayLose.getAsBoolean()) {
            close();
        }
    }

    /** Ends the window, whatever that loses. */
    public void close() {
        if (waiting || FileWrites.underWay().isEmpty()) {
            endOnce();
        } else {
            waiting = true;
            await();
        }
    }

    private void await() {
        FileWrites.underWay()
                .ifPresentOrElse(
                        what -> {
                            if (!ended) {
                                say.accept("Writing " + what
                                        + "; the window closes after that. Quit again to leave it unfinished.");
                                FileWrites.whenDone(this::await);
                            }
                        },
                        this::endOnce);
    }

    private void endOnce() {
        if (!ended) {
            ended = true;
            end.run();
        }
    }
}
