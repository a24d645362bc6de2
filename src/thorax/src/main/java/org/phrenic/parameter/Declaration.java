package org.phrenic.parameter;

import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;

/**
 * What settings of all types declare; the last method of a declaration gives its type.
 *
 * @param key name in scenario files and on the command line, with its unit
 * @param label display name
 * @param effect what a running simulation must do when it changes
 * @param description meaning and origin of the default, in one or two sentences
 */
public record Declaration(String key, String label, Effect effect, String description) {
    public Declaration describedAs(String sentences) {
        return new Declaration(key, label, effect, sentences);
    }

    public SwitchSetting onOff(boolean initial) {
        return new SwitchSetting(this, initial);
    }

    /** A whole number from 1 to {@code maximum}. */
    public WholeSetting whole(int maximum, ToIntFunction<SettingValues> initial) {
        return new WholeSetting(this, maximum, initial);
    }

    /** A number, offered from {@code least} to {@code greatest}. */
    public NumberSetting number(String unit, double least, double greatest, ToDoubleFunction<SettingValues> initial) {
        return new NumberSetting(this, new NumberSetting.Range(unit, least, greatest), initial);
    }

    /** A number from {@code least} to {@code greatest}; a scenario that states less is refused. */
    public NumberSetting numberFrom(
            String unit, double least, double greatest, ToDoubleFunction<SettingValues> initial) {
        return new NumberSetting(this, new NumberSetting.Range(unit, least, greatest, true), initial);
    }

    /**
     * One of several named values.
     *
     * @param values in display order
     * @param name of a value in scenario files
     */
    public <T> ChoiceSetting<T> choice(
            Collection<T> values, Function<T, String> name, Function<SettingValues, T> initial) {
        return new ChoiceSetting<>(this, values, name, initial);
    }

    /** A constant of an enumeration, named in lower case. */
    public <E extends Enum<E>> ChoiceSetting<E> choice(E initial) {
        List<E> all = List.of(initial.getDeclaringClass().getEnumConstants());
        return choice(all, ChoiceSetting::nameOf, values -> initial);
    }

    /** @param plain value as in a scenario file; null if the file omits the key */
    public <T> Setting<T> parsed(
            Function<SettingValues, T> initial, ParsedSetting.Reader<T> reader, Function<T, Object> plain) {
        return new ParsedSetting<>(this, initial, reader, plain);
    }
}
