package org.phrenic.study.validation;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;

/** Breaths that are compared with people: what is measured on a structure that the scene lacks is unknown, not 0. */
final class KnownObservables {
    private static final List<String> OF_LIVER =
            List.of("liver_si_mm", "liver_ap_mm", "liver_lr_mm", "liver_top_mm", "liver_edge_mm");
    private static final List<String> OF_LUNGS = List.of("lung_volume_change_ml");
    private static final List<String> OF_STERNUM = List.of("ap_change_mm", "sternum_cranial_mm", "sternum_ventral_mm");

    private KnownObservables() {}

    /**
     * Simulates a preset ({@link PresetRun}).
     *
     * @param wanted names of additional observables
     */
    static BreathSeries of(Scenario scenario, Thorax thorax, Collection<String> wanted) {
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            Set<String> unknown = unknown(simulation.scene());
            return PresetRun.of(simulation, PresetRun.SAMPLE_S, wanted).withUnknown(unknown);
        }
    }

    private static Set<String> unknown(Scene scene) {
        Set<String> unknown = new LinkedHashSet<>();
        if (scene.liver().isEmpty()) {
            unknown.addAll(OF_LIVER);
        }
        if (scene.lungs().isEmpty() && scene.embeddedLungs().isEmpty()) {
            unknown.addAll(OF_LUNGS);
        }
        boolean sternum = !scene.thorax().structuresOf(StructureKind.STERNUM).isEmpty();
        if (!sternum || scene.pose().cage().sternum() == RibCage.TRUNK) {
            unknown.addAll(OF_STERNUM);
        }
        return unknown;
    }
}
