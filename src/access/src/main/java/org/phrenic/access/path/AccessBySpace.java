package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;

/**
 * The points of an access map that the needle reaches, counted by the intercostal space that their path passes at the
 * first moment.
 */
public final class AccessBySpace {
    private static final String OTHER = "over bone or below the costal margin";

    /**
     * A row.
     *
     * @param space such as "7th intercostal space, right"
     * @param free points that give access over the whole breath
     * @param part in part of it
     * @param never at no time
     */
    public record Row(String space, int free, int part, int never) {}

    private AccessBySpace() {}

    /** Counts; afterwards the scene shows the first moment. */
    public static List<Row> of(MovingAnatomy scene, AccessMap map, Needle needle) {
        scene.update(map.cycle().get(0).frame());
        PathAnalyzer reader = new PathAnalyzer(scene, needle);
        Map<String, int[]> counts = new TreeMap<>();
        double[] skin = scene.skin().positions();
        for (int v = 0; v < map.size(); v++) {
            if (map.isInReach(0, v)) {
                String key = reader.analyze(Arrays.copyOfRange(skin, 3 * v, 3 * v + 3), map.target(0))
                        .space()
                        .map(s -> String.format(java.util.Locale.ROOT, "%02d %s", s.number(), s.label()))
                        .orElse("99 " + OTHER);
                counts.computeIfAbsent(key, k -> new int[3])[map.access(v).ordinal()]++;
            }
        }
        List<Row> rows = new ArrayList<>();
        counts.forEach((key, c) -> rows.add(new Row(key.substring(3), c[0], c[1], c[2])));
        return rows;
    }

    /** Plain values for a report. */
    public static List<Map<String, Object>> plain(List<Row> rows) {
        return rows.stream()
                .map(row -> {
                    Map<String, Object> map = new LinkedHashMap<>();
                    map.put("space", row.space());
                    map.put("free", row.free());
                    map.put("in_part", row.part());
                    map.put("never", row.never());
                    return map;
                })
                .toList();
    }
}
