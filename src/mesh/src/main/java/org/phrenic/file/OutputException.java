package org.phrenic.file;

/** A file could not be written. The message is one sentence that names the file, its folder and the reason. */
public final class OutputException extends RuntimeException {
    public OutputException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
