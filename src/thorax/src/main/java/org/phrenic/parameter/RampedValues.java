package org.phrenic.parameter;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Values of all parameters and smoothly acting switches of a run. Entries are created when the parts of a scene request
 * them.
 */
public final class RampedValues {
    private final Map<Setting<?>, RampedValue> values = new LinkedHashMap<>();
    private final List<RampedValue> tissue = new ArrayList<>();
    private final List<RampedValue> scene = new ArrayList<>();
    private SettingValues start;

    /** @param start settings at the start of the run */
    public RampedValues(SettingValues start) {
        this.start = start;
    }

    /** The effective value of a parameter ({@link SettingValues#effective}). */
    public RampedValue of(Parameter parameter) {
        return values.computeIfAbsent(parameter, p -> track(p, new RampedValue(v -> v.effective(parameter), start)));
    }

    /** A switch as a number: 1 on, 0 off. */
    public RampedValue of(SwitchSetting setting) {
        return values.computeIfAbsent(setting, s -> track(s, new RampedValue(v -> v.get(setting) ? 1 : 0, start)));
    }

    private RampedValue track(Setting<?> setting, RampedValue value) {
        if (setting.effect() == Effect.TISSUE) {
            tissue.add(value);
        } else if (setting.effect() == Effect.SCENE) {
            scene.add(value);
        }
        return value;
    }

    /** Whether springs, masses or damping in given settings differ from the targets before the changes of a step. */
    public boolean differsInTissue(SettingValues settings, long step) {
        return tissue.stream().anyMatch(value -> Double.compare(value.in(settings), value.targetBefore(step)) != 0);
    }

    /** Whether all ramps of springs, masses and damping before the changes of a step had ended at a time. */
    public boolean hadTissueArrived(long step, double timeS) {
        return tissue.stream().allMatch(value -> value.hadArrived(step, timeS));
    }

    /** Starts ramps of all values to those in given settings. */
    public void rampTo(SettingValues settings, long step, double nowS) {
        values.values().forEach(value -> value.rampTo(settings, step, nowS));
    }

    /** Sets all values to those in given settings without ramps, as at the start of a run. */
    public void restart(SettingValues settings) {
        start = settings;
        values.values().forEach(value -> value.restart(settings));
    }

    /** Whether all ramps of springs, masses and damping have ended. */
    public boolean hasTissueArrived(double timeS) {
        return haveArrived(tissue, timeS);
    }

    /** Whether all ramps of other values that are updated at every step have ended. */
    public boolean hasSceneArrived(double timeS) {
        return haveArrived(scene, timeS);
    }

    private static boolean haveArrived(List<RampedValue> list, double timeS) {
        for (RampedValue value : list) {
            if (!value.hasArrived(timeS)) {
                return false;
            }
        }
        return true;
    }
}
