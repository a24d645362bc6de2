package org.phrenic.file;

/**
 * Invalid user input. The message is one sentence that can be shown to the user. It names the file, the location in it
 * (line, byte or key), what was found and what was expected.
 */
public class BadInputException extends RuntimeException {
    public BadInputException(String sentence) {
        super(sentence);
    }

    public BadInputException(String sentence, Throwable cause) {
        super(sentence, cause);
    }

    /**
     * Creates an exception with the message "file: place: problem".
     *
     * @param file the file as the user named it
     * @param place "line 12", "byte 84", "key 'threads'"
     * @param problem "found ..., expected ..."
     */
    public static BadInputException at(String file, String place, String problem) {
        return new BadInputException(file + ": " + place + ": " + problem);
    }
}
