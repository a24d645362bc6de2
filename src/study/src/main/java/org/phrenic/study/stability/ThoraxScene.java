package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.Constraint;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.SlidingSheet;
import org.phrenic.model.material.TissueMass;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/** Scene of a thorax with changes applied during the run. */
final class ThoraxScene implements StabilityScene {
    /** Time in which a body comes to rest, s. */
    static final double SETTLING_S = 20;

    /**
     * Node damping while the scene settles, N s/m. It is about critical for the springs that restore the paper's sheet;
     * with the paper's 0.02 the sheet oscillates for a minute.
     */
    static final double SETTLING_DAMPING = 1;

    private final Simulation simulation;
    private final Consumer<Simulation> beforeStep;
    private final Map<StabilityMeasure, Constraint> contacts = new EnumMap<>(StabilityMeasure.class);

    /** @param beforeStep applied to the simulation before each step */
    ThoraxScene(Scenario scenario, Thorax thorax, Consumer<Simulation> beforeStep) {
        simulation = Simulation.of(scenario, thorax);
        this.beforeStep = beforeStep;
        Scene scene = simulation.scene();
        if (scene.wall().isPresent()) {
            SlidingSheet sheet = scene.slidingSheet();
            int[] nodes = MassSpringBuilder.offset(sheet.vertices(), scene.diaphragm().firstNode);
            // These are never added to the system: they only measure.
            contacts.put(StabilityMeasure.OUTSIDE_MM, new SlidingContact(scene.layout(), nodes, sheet.wall(), 0));
            contacts.put(StabilityMeasure.CROSSED_MM, scene.diaphragm().orderedPairs(scene.layout(), 0));
        }
    }

    static <T> Assignment assignment(Setting<T> setting, T value) {
        return Assignment.of("slider " + setting.key(), setting, value);
    }

    @Override
    public Stepper stepper() {
        return simulation.stepper();
    }

    @Override
    public void step() {
        beforeStep.accept(simulation);
        simulation.step();
    }

    @Override
    public double linkError() {
        return simulation.linkError();
    }

    @Override
    public Map<StabilityMeasure, Double> contactErrors() {
        Map<StabilityMeasure, Double> errors = new EnumMap<>(StabilityMeasure.class);
        contacts.forEach((measure, contact) -> {
            contact.invalidate();
            contact.prepare(system(), simulation.time());
            errors.put(measure, contact.error(system()));
        });
        return errors;
    }

    @Override
    public boolean undoLastChange() {
        return simulation.undoLastChange();
    }

    @Override
    public void stopBreathing() {
        List<Assignment> changes = new ArrayList<>(List.of(assignment(Breathing.DEPTH, 0.0)));
        if (simulation.start().material().uses(TissueMass.DAMPING)) {
            changes.add(assignment(TissueMass.DAMPING, SETTLING_DAMPING));
        }
        simulation.change(changes);
    }

    @Override
    public void close() {
        simulation.close();
    }
}
