package org.phrenic.ui.widget;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.StringSelection;
import java.util.function.Consumer;

/** Text for a clipboard, which another program may hold. */
public final class ClipboardText {
    private ClipboardText() {}

    /**
     * Copies a text.
     *
     * @param refused receives a sentence if the clipboard does not take it
     * @return whether it did
     */
    public static boolean copy(String text, Clipboard clipboard, Consumer<String> refused) {
        try {
            clipboard.setContents(new StringSelection(text), null);
            return true;
        } catch (IllegalStateException busy) {
            refused.accept("The clipboard took no text: " + busy.getMessage());
            return false;
        }
    }
}
