package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.YamlMap;

/**
 * A number of the model that can be tuned. It is declared once, by the part that uses it, and holds no value: a
 * scenario states values and a run has a {@link RampedValue}. After Orekit's {@code ParameterDriver}.
 */
public final class Parameter extends NumberSetting {
    /** First spread of a search for what only bends what the main drives do. */
    private static final double NARROW_SPREAD = 0.4;

    private final Group group;
    private final boolean fromPreset;
    private final SwitchSetting switchedBy;
    private final boolean limitsStep;
    private final FitRange fitRange;

    private Parameter(Builder b) {
        super(b.key, b.label, b.effect, new Range(b.unit, b.minimum, b.maximum), b.initial, b.description);
        group = b.group;
        fromPreset = b.fromPreset;
        switchedBy = b.switchedBy;
        limitsStep = b.limitsStep;
        fitRange = b.fitRange == null ? new FitRange(b.minimum, b.maximum, NARROW_SPREAD) : b.fitRange;
    }

    /** Begins the declaration of a parameter. */
    public static Builder named(String key, String label) {
        return new Builder(key, label);
    }

    /** Heading under which it is shown. */
    public Group group() {
        return group;
    }

    /** Whether the breathing preset gives the default. */
    public boolean isGivenByPreset() {
        return fromPreset;
    }

    /** The switch that makes it act as 0 while it is off. */
    public Optional<SwitchSetting> switchedBy() {
        return Optional.ofNullable(switchedBy);
    }

    /** Whether it has a part in how large a step may be. */
    public boolean limitsStep() {
        return limitsStep;
    }

    /** How a search looks for it. */
    public FitRange fitRange() {
        return fitRange;
    }

    @Override
    public Double read(YamlMap yaml, Path folder) {
        double value = yaml.number(key());
        rangeViolation(value).ifPresent(problem -> {
            throw yaml.bad(key(), problem);
        });
        return value;
    }

    /** What is wrong with {@code value}, as "found 9, expected 0 to 2"; empty if it is within the range. */
    public Optional<String> rangeViolation(double value) {
        return value >= minimum() && value <= maximum()
                ? Optional.empty()
                : Optional.of("found " + number(value) + ", expected " + number(minimum()) + " to " + number(maximum())
                        + (unit().equals("1") ? "" : " " + unit()));
    }

    /**
     * Refuses a value that is not a number or out of range.
     *
     * @return the value
     * @throws IllegalArgumentException with one sentence
     */
    public double requireInRange(double value) {
        rangeViolation(value).ifPresent(problem -> {
            throw new IllegalArgumentException(key() + ": " + problem);
        });
        return value;
    }

    /**
     * Declares a parameter step by step. Without more it is a plain number that is read at every evaluation of the
     * forces.
     */
    public static final class Builder {
        private final String key;
        private final String label;
        private String unit = "1";
        private double minimum;
        private double maximum = 1;
        private ToDoubleFunction<SettingValues> initial = values -> Double.NaN;
        private boolean fromPreset;
        private Effect effect = Effect.DRIVE;
        private Group group = Group.TISSUE;
        private SwitchSetting switchedBy;
        private boolean limitsStep;
        private FitRange fitRange;
        private String description = "";

        private Builder(String key, String label) {
            this.key = key;
            this.label = label;
        }

        public Builder unit(String name) {
            unit = name;
            return this;
        }

        /** Least and greatest value. */
        public Builder range(double least, double greatest) {
            minimum = least;
            maximum = greatest;
            return this;
        }

        /** Value where a scenario states none and the material has no other. */
        public Builder initial(double value) {
            initial = values -> value;
            return this;
        }

        /** Value where a scenario states none, which the breathing preset gives. */
        public Builder initialOfPreset(ToDoubleFunction<SettingValues> value) {
            initial = value;
            fromPreset = true;
            return this;
        }

        public Builder effect(Effect what) {
            effect = what;
            return this;
        }

        public Builder group(Group heading) {
            group = heading;
            return this;
        }

        /** The switch that makes it act as 0 while it is off. */
        public Builder switchedBy(SwitchSetting setting) {
            switchedBy = setting;
            return this;
        }

        /** Springs and masses depend on it, and so does the longest stable step. */
        public Builder limitsStep() {
            limitsStep = true;
            return effect(Effect.TISSUE);
        }

        /** Bounds of a search that says no other. */
        public Builder fitted(double least, double greatest) {
            return fitted(least, greatest, NARROW_SPREAD);
        }

        /** As {@link #fitted(double, double)}, with another first spread. */
        public Builder fitted(double least, double greatest, double spread) {
            fitRange = new FitRange(least, greatest, spread);
            return this;
        }

        /** Ends the declaration. */
        public Parameter describedAs(String sentence) {
            description = sentence;
            return new Parameter(this);
        }
    }
}
