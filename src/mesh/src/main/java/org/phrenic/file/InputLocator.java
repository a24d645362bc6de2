package org.phrenic.file;

/** Names the place of values in a file, for error messages. */
public interface InputLocator {
    /** The location of the value read last: a byte offset or an index. */
    long location();

    /** An exception whose sentence names the file and {@code place}. */
    BadInputException badInput(long place, String problem);

    default BadInputException badInput(String problem) {
        return badInput(location(), problem);
    }
}
