package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/** Bodies made from the two virtual ones by {@link BodyVariation}. */
public final class RandomBodies {
    private static final List<String> SOURCES = List.of(RunSettings.VIRTUAL_MAN, RunSettings.VIRTUAL_WOMAN);

    private RandomBodies() {}

    /**
     * Bodies of random size and shape, from the male and the female in turn. The same seed gives the same bodies; a
     * longer series begins with the shorter one.
     *
     * @param scenario whose resolution the bodies have
     * @param count number of bodies
     */
    public static List<BodyCase> series(Scenario scenario, int count, long seed) {
        List<BodyCase> bodies = new ArrayList<>();
        for (int number = 1; number <= count; number++) {
            String source = SOURCES.get((number - 1) % SOURCES.size());
            bodies.add(body(
                    scenario,
                    Numbers.format("random-%d-%02d", seed, number),
                    source,
                    BodyVariation.random(seed, number)));
        }
        return bodies;
    }

    /** Bodies at the ends of what occurs: heavy, with a high liver, with a barrel chest; of both sources. */
    public static List<BodyCase> extremes(Scenario scenario) {
        List<BodyCase> bodies = new ArrayList<>();
        for (String source : SOURCES) {
            String sex = source.substring(source.lastIndexOf('-') + 1);
            bodies.add(body(scenario, "heavy-" + sex, source, BodyVariation.HEAVY));
            bodies.add(body(scenario, "high-liver-" + sex, source, BodyVariation.HIGH_LIVER));
            bodies.add(body(scenario, "barrel-" + sex, source, BodyVariation.BARREL));
        }
        return bodies;
    }

    private static BodyCase body(Scenario scenario, String name, String source, BodyVariation variation) {
        Scenario with = scenario.with(List.of(Assignment.read("body", "anatomy", source)));
        return new BodyCase(
                name,
                source.substring(source.indexOf('/') + 1) + ", " + variation.description(),
                variation.scaleZ(),
                () -> variation.of(SimulationRun.loadThorax(with), name));
    }
}
