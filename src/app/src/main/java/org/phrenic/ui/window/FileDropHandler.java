package org.phrenic.ui.window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;

/** Opens a scenario, a plan, a thorax folder, a trace, a label volume or a folder of masks dropped on the window. */
final class FileDropHandler extends TransferHandler {
    private final transient Consumer<Path> open;
    private final transient Consumer<String> refuse;

    /** @param refuse gets a message if no file can be opened */
    FileDropHandler(Consumer<Path> open, Consumer<String> refuse) {
        this.open = open;
        this.refuse = refuse;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        try {
            List<?> files = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (files.size() != 1) {
                refuse.accept("found " + files.size()
                        + " files, expected one scenario, plan, thorax folder, trace, label volume or folder of masks");
                return false;
            }
            open.accept(FileNames.path(((File) files.get(0)).getPath()));
            return true;
        } catch (BadInputException e) {
            refuse.accept(e.getMessage());
            return false;
        } catch (UnsupportedFlavorException | IOException e) {
            refuse.accept("what was dropped could not be read (" + e.getMessage() + "), expected a file");
            return false;
        }
    }
}
