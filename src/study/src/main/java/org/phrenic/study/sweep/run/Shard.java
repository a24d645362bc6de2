package org.phrenic.study.sweep.run;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * A part of the runs of a study: those whose index has a remainder.
 *
 * @param number from 0 to {@code count} - 1
 * @param count number of shards
 */
public record Shard(int number, int count) {
    /** The whole study. */
    public static final Shard WHOLE = new Shard(0, 1);

    private static final Pattern FORM = Pattern.compile("(\\d+)/(\\d+)");
    private static final long MOST = 1_000_000;

    /**
     * Parses {@code k/n}, such as {@code 0/3}.
     *
     * @throws BadInputException with one sentence
     */
    public static Shard parse(String text) {
        Matcher form = FORM.matcher(text);
        if (form.matches()) {
            long k = Numbers.parseWhole(form.group(1), 0, MOST).orElse(MOST);
            long n = Numbers.parseWhole(form.group(2), 1, MOST).orElse(0);
            if (k < n) {
                return new Shard((int) k, (int) n);
            }
        }
        throw new BadInputException("--shard: found '" + text + "', expected k/n with k from 0 to n - 1, such as 0/3");
    }

    public boolean contains(int index) {
        return index % count == number;
    }

    /** Name of its journal: {@code journal.csv} for the whole study, {@code journal-0-of-3.csv} for a shard. */
    String journalName() {
        return count == 1 ? "journal.csv" : "journal-" + number + "-of-" + count + ".csv";
    }
}
