package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.Transferable;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.Test;

class LogDialogTest {
    private final List<String> told = new ArrayList<>();
    private final Handler listening = new Handler() {
        @Override
        public void publish(LogRecord line) {
            told.add(line.getMessage());
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
    };

    /** On some systems one program has the clipboard at a time. */
    @Test
    void aClipboardThatIsHeldElsewhereIsTold() {
        Clipboard busy = new Clipboard("busy") {
            @Override
            public synchronized void setContents(Transferable contents, ClipboardOwner owner) {
                throw new IllegalStateException("cannot open system clipboard");
            }
        };
        Logger logger = Logger.getLogger(LogDialog.class.getName());
        logger.addHandler(listening);
        try {
            LogDialog.copy("a line", busy);
        } finally {
            logger.removeHandler(listening);
        }
        assertThat(told).singleElement().asString().contains("The clipboard took no text");
    }
}
