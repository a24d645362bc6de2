package org.phrenic.file;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** A file could not be written. The message is one sentence that names the file, its folder and the reason. */
public final class OutputException extends RuntimeException {
    public OutputException(String sentence, Throwable cause) {
        super(sentence, cause);
    }

    /** Whether the place is wrong, such as a folder where no one may write; a full disk is not. */
    public boolean isOfPlace() {
        Throwable cause = getCause();
        return cause instanceof AccessDeniedException
                || cause instanceof FileAlreadyExistsException
                || cause instanceof NoSuchFileException
                || cause instanceof NotDirectoryException;
    }
}
