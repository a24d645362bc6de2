package org.phrenic.file;

import java.io.IOException;

/**
 * Input that cannot be reached, such as a folder that is gone or a disk that fails. Unlike wrong content, it may be
 * read another time.
 */
public final class UnreadableException extends BadInputException {
    public UnreadableException(String sentence, IOException cause) {
        super(sentence, cause);
    }
}
