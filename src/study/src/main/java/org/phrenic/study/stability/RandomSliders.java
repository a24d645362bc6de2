package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/**
 * Moves sliders from end to end at random, several at a time; then restores all, stops the breath and lets the body
 * come to rest.
 */
final class RandomSliders implements Consumer<Simulation> {
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
     * @param start initial scenario
     * @param durationS of the run, s: all is restored in time for the body to come to rest
     */
    RandomSliders(Scenario start, double durationS) {
        untilS = durationS - ThoraxScene.SETTLING_S;
        initialScenario = start;
        parameters = Arrays.stream(Parameter.values())
                .filter(p -> p.isUsedBy(start.material()))
                .toArray(Parameter[]::new);
    }

    @Override
    public void accept(Simulation simulation) {
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
                // A refused change leaves the scene as it was, as for a user at the sliders.
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
                list.add(ThoraxScene.assignment(p.key(), random.nextBoolean() ? p.minimum() : p.maximum()));
            } else if (which < parameters.length + SWITCHES.size()) {
                list.add(ThoraxScene.assignment(SWITCHES.get(which - parameters.length), random.nextBoolean()));
            } else {
                list.add(ThoraxScene.assignment("preset", PRESETS.get(random.nextInt(PRESETS.size()))));
            }
        }
        return list;
    }

    /** The initial values, with the breath stopped. */
    private List<Assignment> restoringChanges() {
        List<Assignment> list = new ArrayList<>();
        list.add(ThoraxScene.assignment("preset", initialScenario.preset()));
        for (String key : SWITCHES) {
            list.add(ThoraxScene.assignment(key, initialScenario.toMap().get(key)));
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
                value = ThoraxScene.SETTLING_DAMPING;
            }
            list.add(ThoraxScene.assignment(p.key(), value));
        }
        return list;
    }
}
