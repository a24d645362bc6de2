package org.phrenic.document;

/** A file of the program itself cannot be read, such as where the program is replaced while it runs. */
public final class ShippedFileException extends RuntimeException {
    ShippedFileException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
