package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** Whether a breath of a study has a hold, which creep needs. */
final class HeldBreaths {
    /** Factors that may hold a breath. */
    private static final List<String> KEYS =
            List.of(Breathing.PRESET.key(), Breathing.TRACE.key(), Breathing.HOLD.key());

    private HeldBreaths() {}

    /** Whether at least one combination of listed presets, recordings and holds has one. */
    static boolean in(SweepStudy study) {
        return combinations(study).stream().anyMatch(assignments -> isHeld(study.scenario(), assignments));
    }

    private static Set<List<Assignment>> combinations(SweepStudy study) {
        List<Factor> factors =
                study.factors().stream().filter(f -> KEYS.contains(f.key())).toList();
        Set<List<Assignment>> all = new LinkedHashSet<>();
        if (study.design().kind() == DesignSpec.Kind.LIST) {
            for (List<String> point : study.design().points()) {
                List<Assignment> one = new ArrayList<>();
                for (Factor factor : factors) {
                    one.add(assignment(factor, point.get(study.factors().indexOf(factor))));
                }
                all.add(one);
            }
            return all;
        }
        all.add(List.of());
        for (Factor factor : factors) {
            Set<List<Assignment>> longer = new LinkedHashSet<>();
            for (List<Assignment> shorter : all) {
                for (String value : new LinkedHashSet<>(factor.values())) {
                    List<Assignment> one = new ArrayList<>(shorter);
                    one.add(assignment(factor, value));
                    longer.add(one);
                }
            }
            all = longer;
        }
        return all;
    }

    private static Assignment assignment(Factor factor, String value) {
        return Assignment.read("factor '" + factor.key() + "'", factor.key(), value);
    }

    /** Whether a combination has a hold; one that is refused has no breath. */
    private static boolean isHeld(Scenario shared, List<Assignment> assignments) {
        try {
            return isHeld(shared.with(assignments));
        } catch (BadInputException refused) {
            return false;
        }
    }

    /** Whether a change on the way holds the breath; with another preset the breath that is measured ends. */
    private static boolean holds(Scenario scenario, ScheduledChange change) {
        Assignment assignment = change.assignment();
        return assignment.key().equals(Breathing.HOLD.key())
                && isHeld(scenario.withChanges(List.of()).with(List.of(assignment)));
    }

    private static boolean isHeld(Scenario scenario) {
        BreathingPattern pattern = Breathing.patternOf(scenario);
        BreathState state = new BreathState();
        boolean held = scenario.hold() || scenario.changes().stream().anyMatch(change -> holds(scenario, change));
        // The closed glottis of a cough, which comes again, is no hold that a breath ends with.
        boolean ends = Double.isInfinite(pattern.periodS());
        for (double t = 0; ends && !held && t < pattern.fullDurationS(); t += BreathModel.SAMPLE_S) {
            pattern.at(t, state);
            held = state.respiratoryPhase == RespiratoryPhase.HOLD;
        }
        return held;
    }
}
