package org.phrenic.scenario;

import java.io.IOException;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingTraceReader;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.breathing.pattern.TracePattern;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;

/**
 * The breathing pattern a scenario asks for: its preset or trace, with the rate, depth and balance that the scenario
 * states.
 */
public final class ScenarioBreathing {
    private ScenarioBreathing() {}

    public static BreathingPattern patternOf(Scenario scenario) {
        BreathingPreset preset = scenario.breathing();
        BreathingParameters p = preset.parameters();
        if (scenario.states(Parameter.RATE)) {
            p = p.withRatePerMin(scenario.value(Parameter.RATE));
        }
        if (scenario.states(Parameter.INSPIRATORY_FRACTION)) {
            p = p.withInspiratoryFraction(scenario.value(Parameter.INSPIRATORY_FRACTION));
        }
        if (scenario.states(Parameter.CHEST_SHARE)) {
            p = p.withChestShare(scenario.value(Parameter.CHEST_SHARE));
        }
        if (scenario.states(Parameter.DEPTH)) {
            p = p.withDepth(scenario.value(Parameter.DEPTH));
        }
        if (scenario.trace().isPresent()) {
            try {
                return new TracePattern(
                        BreathingTraceReader.read(scenario.trace().get()), p, true);
            } catch (IOException e) {
                throw new BadInputException(
                        scenario.trace().get() + ": found nothing that can be read, expected a recorded breath", e);
            }
        }
        return preset.pattern(p);
    }
}
