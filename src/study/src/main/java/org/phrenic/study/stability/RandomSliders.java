package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.model.material.TissueMass;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.model.material.WallContact;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.SwitchSetting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/**
 * Sets random sliders to the ends of their ranges, several at a time. It then restores the initial values, stops the
 * breath and lets the body come to rest.
 */
final class RandomSliders implements Consumer<Simulation> {
    private static final long SEED = 2009;
    private static final double MIN_INTERVAL_S = 0.05;
    private static final double SPREAD_S = 1;
    private static final int MAX_CHANGES = 4;
    private static final List<SwitchSetting> SWITCHES = List.of(
            Muscle.MUSCLE,
            TransdiaphragmaticPressure.PRESSURE,
            RibRotation.RIBS,
            RigidTendon.TENSEGRITY,
            WallContact.CONTACT,
            Breathing.HOLD);
    private static final List<String> PRESETS = List.of("quiet", "deep", "sniff", "cough", "rapid-shallow");
    private final Random random = new Random(SEED);
    private final Scenario initialScenario;
    private final List<Parameter> parameters;
    private final double untilS;
    private double next = MIN_INTERVAL_S;
    private boolean restored;

    /**
     * @param start initial scenario
     * @param durationS duration of the run, s; the values are restored early enough for the body to come to rest
     */
    RandomSliders(Scenario start, double durationS) {
        untilS = durationS - ThoraxScene.SETTLING_S;
        initialScenario = start;
        parameters = start.material().parameters();
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
            } catch (IllegalArgumentException | BadInputException refused) {
                // A refused change leaves the scene unchanged, as in the program.
                return;
            }
        }
    }

    private List<Assignment> randomChanges() {
        List<Assignment> list = new ArrayList<>();
        int count = 1 + random.nextInt(MAX_CHANGES);
        for (int i = 0; i < count; i++) {
            int which = random.nextInt(parameters.size() + SWITCHES.size() + 1);
            if (which < parameters.size()) {
                Parameter p = parameters.get(which);
                list.add(ThoraxScene.assignment(p, random.nextBoolean() ? p.minimum() : p.maximum()));
            } else if (which < parameters.size() + SWITCHES.size()) {
                list.add(ThoraxScene.assignment(SWITCHES.get(which - parameters.size()), random.nextBoolean()));
            } else {
                list.add(Assignment.read("slider preset", "preset", PRESETS.get(random.nextInt(PRESETS.size()))));
            }
        }
        return list;
    }

    /** The initial values, with the breath stopped. */
    private List<Assignment> restoringChanges() {
        List<Assignment> list = new ArrayList<>();
        list.add(ThoraxScene.assignment(Breathing.PRESET, initialScenario.breathing()));
        SWITCHES.forEach(setting -> list.add(ThoraxScene.assignment(setting, initialScenario.get(setting))));
        for (Parameter p : parameters) {
            double value = initialScenario.get(p);
            if (p == Breathing.DEPTH) {
                value = 0;
            } else if (p == TissueMass.DAMPING) {
                value = ThoraxScene.SETTLING_DAMPING;
            }
            list.add(ThoraxScene.assignment(p, value));
        }
        return list;
    }
}
