package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.YamlMap;

/**
 * A tunable number of the model. The part that uses it declares it once. It holds no value: a scenario states values,
 * and a run has a {@link RampedValue}. Modelled on Orekit's {@code ParameterDriver}.
 */
public final class Parameter extends NumberSetting {
    /** Initial search width of a parameter that only modifies the effect of the main drives. */
    private static final double NARROW_SPREAD = 0.4;

    private final Group group;
    private final boolean fromPreset;
    private final SwitchSetting switchedBy;
    private final boolean limitsStep;
    private final FitRange fitRange;

    private Parameter(Builder b) {
        super(b.declaration, new Range(b.unit, b.minimum, b.maximum), b.initial);
        group = b.group;
        fromPreset = b.fromPreset;
        switchedBy = b.switchedBy;
        limitsStep = b.limitsStep;
        fitRange = b.fitRange == null ? new FitRange(b.minimum, b.maximum, NARROW_SPREAD) : b.fitRange;
    }

    /** Starts the declaration of a parameter. */
    public static Builder named(String key, String label) {
        return new Builder(new Declaration(key, label, Effect.DRIVE, ""));
    }

    /** Heading under which it is displayed. */
    public Group group() {
        return group;
    }

    /** Whether the breathing preset gives the default. */
    public boolean isGivenByPreset() {
        return fromPreset;
    }

    /** The switch that sets its effective value to 0 while it is off. */
    public Optional<SwitchSetting> switchedBy() {
        return Optional.ofNullable(switchedBy);
    }

    /** Whether it affects the stability limit of the time step. */
    public boolean limitsStep() {
        return limitsStep;
    }

    /** Search range in a fit. */
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

    /** Range error as "found 9, expected 0 to 2"; empty if {@code value} is within the range. */
    public Optional<String> rangeViolation(double value) {
        return value >= minimum() && value <= maximum()
                ? Optional.empty()
                : Optional.of("found " + number(value) + ", expected " + number(minimum()) + " to " + number(maximum())
                        + (unit().equals("1") ? "" : " " + unit()));
    }

    /**
     * Requires a number within the range.
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

    /** Builder of a parameter. By default it is dimensionless and read at every force evaluation. */
    public static final class Builder {
        private Declaration declaration;
        private String unit = "1";
        private double minimum;
        private double maximum = 1;
        private ToDoubleFunction<SettingValues> initial = values -> Double.NaN;
        private boolean fromPreset;

        private Group group = Group.TISSUE;
        private SwitchSetting switchedBy;
        private boolean limitsStep;
        private FitRange fitRange;

        private Builder(Declaration declaration) {
            this.declaration = declaration;
        }

        /** Sets the smallest and largest value. */
        public Builder range(double least, double greatest) {
            minimum = least;
            maximum = greatest;
            return this;
        }

        /** Sets the smallest and largest value and their unit. */
        public Builder range(double least, double greatest, String unitName) {
            unit = unitName;
            return range(least, greatest);
        }

        /** Sets the default value, which a material can override. */
        public Builder initial(double value) {
            initial = values -> value;
            return this;
        }

        /** Sets a default value that depends on the breathing preset. */
        public Builder initialOfPreset(ToDoubleFunction<SettingValues> value) {
            initial = value;
            fromPreset = true;
            return this;
        }

        public Builder effect(Effect what) {
            declaration = new Declaration(declaration.key(), declaration.label(), what, "");
            return this;
        }

        public Builder group(Group heading) {
            group = heading;
            return this;
        }

        public Builder shown(Group heading, Effect what) {
            return group(heading).effect(what);
        }

        /** Sets the switch that makes the effective value 0 while it is off. */
        public Builder switchedBy(SwitchSetting setting) {
            switchedBy = setting;
            return this;
        }

        /** Declares that springs and masses depend on it, and with them the stability limit. */
        public Builder limitsStep() {
            limitsStep = true;
            return effect(Effect.TISSUE);
        }

        /** Sets the default bounds of a search. */
        public Builder fitted(double least, double greatest) {
            return fitted(least, greatest, NARROW_SPREAD);
        }

        /** As {@link #fitted(double, double)}, with another initial search width. */
        public Builder fitted(double least, double greatest, double spread) {
            fitRange = new FitRange(least, greatest, spread);
            return this;
        }

        /** Completes the declaration. */
        public Parameter describedAs(String sentence) {
            declaration = declaration.describedAs(sentence);
            return new Parameter(this);
        }
    }
}
