package org.phrenic.file;

/** Locates values in an input file for error messages. */
public interface InputLocator {
    /** The location of the value read last: a byte offset or an index. */
    long location();

    /** An exception whose message names the file and {@code place}. */
    BadInputException badInput(long place, String problem);

    default BadInputException badInput(String problem) {
        return badInput(location(), problem);
    }

    /** An exception about the word read last. */
    default BadInputException unexpected(String found, String expected) {
        return badInput("found " + Numbers.quote(found) + ", expected " + expected);
    }
}
