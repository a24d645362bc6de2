package org.phrenic.fit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.fit.search.Evaluation;

/**
 * Breaths of a fit that failed for the same reason.
 *
 * @param reason message of the first of them
 * @param count number of evaluations whose requested breath failed
 * @param gentler how many of them succeeded with less drive
 */
public record FailedBreaths(String reason, int count, int gentler) {
    /** Groups the failed evaluations by reason. Reasons that differ in numbers only are the same. */
    static List<FailedBreaths> of(List<Evaluation> trials) {
        Map<String, List<Evaluation>> groups = new LinkedHashMap<>();
        for (Evaluation e : trials) {
            if (e.hasFailed()) {
                String kind = e.failure().replaceAll("[-+]?\\d[\\d.eE+-]*", "#");
                groups.computeIfAbsent(kind, k -> new ArrayList<>()).add(e);
            }
        }
        return groups.values().stream()
                .map(g -> new FailedBreaths(g.get(0).failure(), g.size(), (int)
                        g.stream().filter(e -> e.drive() > 0).count()))
                .toList();
    }

    /** The failures as a sentence. */
    public String sentence() {
        return count + (count == 1 ? " breath" : " breaths") + " of the search failed, " + gentler
                + " of them succeeded with less drive; the first: " + reason + ".";
    }
}
