package org.phrenic.access.path;

import java.util.List;
import java.util.Set;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.engine.parallel.Workers;

/**
 * What is known of a target before a needle is placed.
 *
 * @param target where it is
 * @param map from where it can be reached
 * @param bySpace the map by intercostal space
 */
public record TargetAccess(TargetLesion target, AccessMap map, List<AccessBySpace.Row> bySpace) {
    /** Works it out; afterwards the scene shows the first moment of the breath. */
    public static TargetAccess of(
            MovingAnatomy scene,
            List<BreathMoment> cycle,
            TargetLesion target,
            Needle needle,
            Set<NoGoZone> avoided,
            Workers workers) {
        AccessMap map = AccessMap.of(scene, cycle, target, needle, avoided, workers);
        return new TargetAccess(target, map, AccessBySpace.of(scene, map, needle));
    }
}
