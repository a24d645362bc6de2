package org.phrenic.ui.session;

import java.util.function.Consumer;

/** Ends a window once what is being written is whole; asked again meanwhile, at once. On the event dispatch thread. */
public final class QuitAfterWrites {
    private final Consumer<String> say;
    private final Runnable end;
    private boolean waiting;
    private boolean ended;

    /**
     * @param say tells the user what is waited for
     * @param end ends the window; called once
     */
    public QuitAfterWrites(Consumer<String> say, Runnable end) {
        this.say = say;
        this.end = end;
    }

    public void quit() {
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
