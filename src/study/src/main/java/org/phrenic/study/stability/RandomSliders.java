package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/**
 * Throws sliders from end to end at random, several at a time, then puts all back, stops breathing and lets the body
 * come to rest.
 */
final class RandomSliders implements ThoraxScene.Intervention {
    private static final long SEED = 2009;
    private static final double MIN_INTERVAL_S = 0.05;
    private static final double SPREAD_S = 1;
    private static final int MAX_CHANGES = 4;
    private static final List<String> SWITCHES = List.of("muscle", "pressure", "ribs", "tensegrity", "contact", "hold");
    private static final List<String> PRESETS = List.of("quiet", "deep", "sniff", "cough", "rapid-shallow");
    private final Random random = new Random(SEED);
    private final Scenario initialScenario;
    private final Parameter[] parameters;
    private final double untilS;
    private double next = MIN_INTERVAL_S;
    private boolean restored;

    /**
     * @param start what the body does at first
     * @param untilS when all is put back, s
     */
    RandomSliders(Scenario start, double untilS) {
        this.untilS = untilS;
        initialScenario = start;
        parameters = Arrays.stream(Parameter.values())
                .filter(p -> p.isUsedBy(start.material()))
                .toArray(Parameter[]::new);
    }

    @Override
    public void beforeStep(Simulation simulation) {
        double now = simulation.time();
        if (now >= untilS) {
            if (!restored) {
                simulation.change(restoringChanges());
                restored = true;
            }
        } else if (now >= next) {
            next = now + MIN_INTERVAL_S + SPREAD_S * random.nextDouble() * random.nextDouble();
            try {
                simulation.change(randomChanges());
            } catch (IllegalArgumentException refused) {
                // What cannot be breathed, or stepped, is refused and nothing has changed: as for anybody at the
                // sliders, it goes on.
                return;
            }
        }
    }

    private List<Assignment> randomChanges() {
        List<Assignment> list = new ArrayList<>();
        int count = 1 + random.nextInt(MAX_CHANGES);
        for (int i = 0; i < count; i++) {
            int which = random.nextInt(parameters.length + SWITCHES.size() + 1);
            if (which < parameters.length) {
                Parameter p = parameters[which];
                list.add(BreathStop.assignment(p.key(), random.nextBoolean() ? p.minimum() : p.maximum()));
            } else if (which < parameters.length + SWITCHES.size()) {
                list.add(BreathStop.assignment(SWITCHES.get(which - parameters.length), random.nextBoolean()));
            } else {
                list.add(BreathStop.assignment("preset", PRESETS.get(random.nextInt(PRESETS.size()))));
            }
        }
        return list;
    }

    /** All as it was, but no breath any more. */
    private List<Assignment> restoringChanges() {
        List<Assignment> list = new ArrayList<>();
        list.add(BreathStop.assignment("preset", initialScenario.preset()));
        for (String key : SWITCHES) {
            list.add(BreathStop.assignment(key, initialScenario.toMap().get(key)));
        }
        var breath = initialScenario.breathing().parameters();
        for (Parameter p : parameters) {
            double value = initialScenario.value(p);
            if (p == Parameter.RATE) {
                value = breath.ratePerMin();
            } else if (p == Parameter.INSPIRATORY_FRACTION) {
                value = breath.inspiratoryFraction();
            } else if (p == Parameter.CHEST_SHARE) {
                value = breath.chestShare();
            } else if (p == Parameter.DEPTH) {
                value = 0;
            } else if (p == Parameter.DAMPING) {
                value = BreathStop.DAMPING;
            }
            list.add(BreathStop.assignment(p.key(), value));
        }
        return list;
    }
}
