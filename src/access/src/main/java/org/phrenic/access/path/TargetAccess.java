package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.OrderedValues;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.Numbers;

/**
 * Access to a target, computed before a needle is placed.
 *
 * @param bySpace skin points in reach of the needle, grouped by the way of their path at the first moment
 */
public record TargetAccess(TargetLesion target, AccessMap map, List<SpaceCount> bySpace) {
    /**
     * Number of skin points whose path enters by one way.
     *
     * @param space name of the way, such as "7th intercostal space, right" or "subxiphoid"
     * @param free points whose path is free during the whole breath
     * @param part points whose path is free during part of the breath
     * @param never points whose path is never free
     */
    public record SpaceCount(String space, int free, int part, int never) {
        public Map<String, Object> toMap() {
            return new OrderedValues()
                    .with("space", space)
                    .with("free", free)
                    .with("in_part", part)
                    .with("never", never);
        }
    }

    /** Computes the access map. Afterwards the anatomy is at the first moment of the breath. */
    public static TargetAccess of(
            MovingAnatomy anatomy,
            List<BreathMoment> cycle,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided,
            Workers workers) {
        AccessMap map = AccessMap.of(anatomy, cycle, target, needle, avoided, workers);
        return new TargetAccess(target, map, count(anatomy, map, needle));
    }

    private static List<SpaceCount> count(MovingAnatomy anatomy, AccessMap map, Needle needle) {
        anatomy.update(map.cycle().get(0).frame());
        PathAnalyzer analyzer = new PathAnalyzer(anatomy, needle);
        Map<String, int[]> counts = new TreeMap<>();
        double[] skin = anatomy.skin().positions();
        for (int v = 0; v < map.size(); v++) {
            if (map.isInReach(0, v)) {
                EntryWay way = analyzer.way(Arrays.copyOfRange(skin, 3 * v, 3 * v + 3), map.target(0));
                int number = way.space()
                        .map(IntercostalSpace::number)
                        .orElse(90 + way.kind().ordinal());
                String key = Numbers.format("%02d %s", number, way.label());
                counts.computeIfAbsent(key, k -> new int[3])[map.access(v).ordinal()]++;
            }
        }
        List<SpaceCount> rows = new ArrayList<>();
        counts.forEach((key, c) -> rows.add(new SpaceCount(key.substring(3), c[0], c[1], c[2])));
        return rows;
    }
}
