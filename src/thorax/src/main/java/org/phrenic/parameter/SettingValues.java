package org.phrenic.parameter;

/** Values of all settings: those that a scenario states, and defaults for the others. */
public interface SettingValues {
    /** The stated value, otherwise the default. NaN for a parameter that the material does not use. */
    <T> T get(Setting<T> setting);

    /** Whether the scenario states a value. */
    boolean states(Setting<?> setting);

    /** Effective value of a parameter: 0 while its switch is off. */
    default double effective(Parameter parameter) {
        return parameter.switchedBy().map(this::get).orElse(true) ? get(parameter) : 0;
    }
}
