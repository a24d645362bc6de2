package org.phrenic.rehearsal;

import java.util.List;
import java.util.Set;
import org.phrenic.engine.Workers;

/**
 * What is known of a target before a needle is placed.
 *
 * @param target where it is
 * @param map from where it can be reached
 * @param spaces the map by intercostal space
 */
public record TargetStudy(Target target, AccessMap map, List<SpaceTable.Row> spaces) {
    /** Works it out; afterwards the scene shows the first moment of the breath. */
    public static TargetStudy of(
            MovingScene scene,
            List<BreathMoment> cycle,
            Target target,
            Needle needle,
            Set<NoGo> avoided,
            Workers workers) {
        AccessMap map = AccessMap.of(scene, cycle, target, needle, avoided, workers);
        return new TargetStudy(target, map, SpaceTable.of(scene, map, needle));
    }
}
