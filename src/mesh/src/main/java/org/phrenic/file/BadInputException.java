package org.phrenic.file;

/**
 * What a user gave cannot be used. The message is one sentence, fit to be shown as it is: it names the file, the place
 * in it (line, byte or key), what was found there and what was expected.
 */
public final class BadInputException extends RuntimeException {
    public BadInputException(String sentence) {
        super(sentence);
    }

    public BadInputException(String sentence, Throwable cause) {
        super(sentence, cause);
    }

    /**
     * The sentence "file: place: problem".
     *
     * @param file the file as the user named it
     * @param place "line 12", "byte 84", "key 'threads'"
     * @param problem "found ..., expected ..."
     */
    public static BadInputException at(String file, String place, String problem) {
        return new BadInputException(file + ": " + place + ": " + problem);
    }
}
