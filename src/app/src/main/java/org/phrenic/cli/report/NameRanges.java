package org.phrenic.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Shortens lists of numbered names to ranges, such as "rib_01_R to rib_06_R". */
public final class NameRanges {
    private static final Pattern NUMBERED = Pattern.compile("(.*?)(\\d+)(\\D*)");

    private NameRanges() {}

    /** The names in their order, with consecutive numbers collapsed into ranges. */
    public static List<String> collapse(List<String> names) {
        List<String> ranges = new ArrayList<>();
        for (int from = 0; from < names.size(); ) {
            int to = from;
            while (to + 1 < names.size() && follows(names.get(to), names.get(to + 1))) {
                to++;
            }
            ranges.add(
                    from == to ? names.get(from) : names.get(from) + (to == from + 1 ? ", " : " to ") + names.get(to));
            from = to + 1;
        }
        return ranges;
    }

    private static boolean follows(String one, String next) {
        Matcher a = NUMBERED.matcher(one);
        Matcher b = NUMBERED.matcher(next);
        return a.matches()
                && b.matches()
                && a.group(1).equals(b.group(1))
                && a.group(3).equals(b.group(3))
                && Integer.parseInt(b.group(2)) == Integer.parseInt(a.group(2)) + 1;
    }
}
