package org.phrenic.ui.window;

import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.event.ActionEvent;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import org.phrenic.simulation.live.ReachedState;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.ClipboardText;

/**
 * Copies the command line that repeats the run so far, without a window, to the clipboard. The simulation answers
 * between two steps; the event dispatch thread does not wait for that.
 */
public final class CopyCommandAction extends AbstractAction {
    private final transient Session session;
    private final transient Supplier<Clipboard> clipboard;

    public CopyCommandAction(Session session) {
        this(session, () -> Toolkit.getDefaultToolkit().getSystemClipboard());
    }

    CopyCommandAction(Session session, Supplier<Clipboard> clipboard) {
        super("Copy as command");
        this.session = session;
        this.clipboard = clipboard;
        String tip = "Puts the line on the clipboard that gives the same numbers, same state_sha256, without a window";
        putValue(SHORT_DESCRIPTION, tip);
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        copy(state -> session.note("Copied: " + state.command()
                + (state.stateHash().isEmpty() ? "" : "; it ends at state_sha256 " + state.stateHash())));
    }

    /** Copies the line, then passes it to {@code done} on the event dispatch thread. */
    void copy(Consumer<ReachedState> done) {
        Consumer<ReachedState> copy = state -> {
            if (ClipboardText.copy(state.command(), clipboard.get(), session::refuse)) {
                done.accept(state);
            }
        };
        BackgroundWorker.execute(session.live()::reproduction, copy, session::refuse);
    }
}
