package org.phrenic.parameter;

/** A value for every setting: those that a scenario states, and defaults. */
public interface SettingValues {
    /** The stated value, else the default. A parameter that the material does not use is NaN. */
    <T> T get(Setting<T> setting);

    /** Whether the scenario states a value. */
    boolean states(Setting<?> setting);

    /** Value of a parameter as it acts: 0 while the switch that it depends on is off. */
    default double effective(Parameter parameter) {
        return parameter.switchedBy().map(this::get).orElse(true) ? get(parameter) : 0;
    }
}
