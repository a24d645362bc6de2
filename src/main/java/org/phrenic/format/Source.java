package org.phrenic.format;

/** Where values come from, so that whoever finds one wrong can say where it stood. */
interface Source {
    /** The place of the value read last: a byte offset or an index, cheap to ask for and to keep. */
    long place();

    /** An exception whose sentence names the file and {@code place}. */
    BadInputException bad(long place, String problem);

    default BadInputException bad(String problem) {
        return bad(place(), problem);
    }
}
