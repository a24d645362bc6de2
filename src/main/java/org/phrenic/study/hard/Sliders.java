package org.phrenic.study.hard;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/** Throws sliders from end to end at random, several at a time, then puts all back, stops breathing and lets the body come to rest. */
final class Sliders implements ThoraxTrial.Doing {
    private static final long SEED = 2009;
    private static final double FEWEST_S = 0.05;
    private static final double SPREAD_S = 1;
    private static final int MOST_AT_ONCE = 4;
    private static final List<String> SWITCHES = List.of("muscle", "pressure", "ribs", "tensegrity", "contact", "hold");
    private static final List<String> PRESETS = List.of("quiet", "deep", "sniff", "cough", "rapid-shallow");
    private final Random random = new Random(SEED);
    private final Scenario calm;
    private final Parameter[] parameters;
    private final double untilS;
    private double next = FEWEST_S;
    private boolean calmed;

    /**
     * @param start what the body does at first
     * @param untilS when all is put back, s
     */
    Sliders(Scenario start, double untilS) {
        this.untilS = untilS;
        calm = start;
        parameters = Arrays.stream(Parameter.values())
                .filter(p -> p.isUsedBy(start.material()))
                .toArray(Parameter[]::new);
    }

    @Override
    public void before(Simulation simulation) {
        double now = simulation.time();
        if (now >= untilS) {
            if (!calmed) {
                simulation.change(putBack());
                calmed = true;
            }
        } else if (now >= next) {
            next = now + FEWEST_S + SPREAD_S * random.nextDouble() * random.nextDouble();
            try {
                simulation.change(thrown());
            } catch (IllegalArgumentException refused) {
                // What cannot be breathed, or stepped, is refused and nothing has changed: as for anybody at the
                // sliders, it goes on.
                return;
            }
        }
    }

    private List<Assignment> thrown() {
        List<Assignment> list = new ArrayList<>();
        int count = 1 + random.nextInt(MOST_AT_ONCE);
        for (int i = 0; i < count; i++) {
            int which = random.nextInt(parameters.length + SWITCHES.size() + 1);
            if (which < parameters.length) {
                Parameter p = parameters[which];
                list.add(Calm.set(p.key(), random.nextBoolean() ? p.minimum() : p.maximum()));
            } else if (which < parameters.length + SWITCHES.size()) {
                list.add(Calm.set(SWITCHES.get(which - parameters.length), random.nextBoolean()));
            } else {
                list.add(Calm.set("preset", PRESETS.get(random.nextInt(PRESETS.size()))));
            }
        }
        return list;
    }

    /** All as it was, but no breath any more. */
    private List<Assignment> putBack() {
        List<Assignment> list = new ArrayList<>();
        list.add(Calm.set("preset", calm.preset()));
        for (String key : SWITCHES) {
            list.add(Calm.set(key, calm.toMap().get(key)));
        }
        var breath = calm.breathing().parameters();
        for (Parameter p : parameters) {
            double value = calm.value(p);
            if (p == Parameter.RATE) {
                value = breath.ratePerMin();
            } else if (p == Parameter.INSPIRATORY_FRACTION) {
                value = breath.inspiratoryFraction();
            } else if (p == Parameter.CHEST_SHARE) {
                value = breath.chestShare();
            } else if (p == Parameter.DEPTH) {
                value = 0;
            } else if (p == Parameter.DAMPING) {
                value = Calm.DAMPING;
            }
            list.add(Calm.set(p.key(), value));
        }
        return list;
    }
}
