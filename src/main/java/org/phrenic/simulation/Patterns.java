package org.phrenic.simulation;

import java.io.IOException;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingPreset;
import org.phrenic.breathing.TraceFile;
import org.phrenic.breathing.TracePattern;
import org.phrenic.format.BadInputException;

/** The breathing pattern a scenario asks for: its preset or trace, with the rate, depth and balance that the scenario states. */
final class Patterns {
    private Patterns() {}

    static BreathingPattern of(Scenario scenario) {
        BreathingPreset preset = scenario.breathing();
        BreathingParameters p = preset.parameters();
        if (scenario.isSet(Parameter.RATE)) {
            p = p.withRatePerMin(scenario.value(Parameter.RATE));
        }
        if (scenario.isSet(Parameter.INSPIRATORY_FRACTION)) {
            p = p.withInspiratoryFraction(scenario.value(Parameter.INSPIRATORY_FRACTION));
        }
        if (scenario.isSet(Parameter.CHEST_SHARE)) {
            p = p.withChestShare(scenario.value(Parameter.CHEST_SHARE));
        }
        if (scenario.isSet(Parameter.DEPTH)) {
            p = p.withDepth(scenario.value(Parameter.DEPTH));
        }
        if (scenario.trace().isPresent()) {
            try {
                return new TracePattern(TraceFile.read(scenario.trace().get()), p, true);
            } catch (IOException e) {
                throw new BadInputException(
                        scenario.trace().get() + ": found nothing that can be read, expected a recorded breath", e);
            }
        }
        return preset.pattern(p);
    }
}
