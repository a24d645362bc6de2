package org.phrenic.access.attempt;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.NoGoZone;

/**
 * The zones that a needle was in.
 *
 * @param secondsIn time in each zone, s
 * @param byCore zones that the throw of a core touched and the needle itself did not
 */
public record ZoneContacts(Map<NoGoZone, Double> secondsIn, Set<NoGoZone> byCore) {
    /** What the throw of a core touched, such as "lung, bone", or "nothing". */
    public String coreText() {
        String zones = byCore.stream().sorted().map(NoGoZone::label).collect(Collectors.joining(", "));
        return zones.isEmpty() ? "nothing" : zones;
    }
}
