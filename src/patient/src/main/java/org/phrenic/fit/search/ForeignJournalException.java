package org.phrenic.fit.search;

import org.phrenic.file.BadInputException;

/** The journal of a fit holds evaluations of another fit or of another build of the program. */
public final class ForeignJournalException extends BadInputException {
    ForeignJournalException(String sentence) {
        super(sentence);
    }
}
