package org.phrenic.file;

/** Where values come from, so that whoever finds one wrong can say where it stood. */
public interface InputLocator {
    /** The place of the value read last: a byte offset or an index, cheap to ask for and to keep. */
    long location();

    /** An exception whose sentence names the file and {@code place}. */
    BadInputException badInput(long place, String problem);

    default BadInputException badInput(String problem) {
        return badInput(location(), problem);
    }
}
