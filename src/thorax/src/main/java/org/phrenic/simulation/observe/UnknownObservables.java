package org.phrenic.simulation.observe;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.model.organ.SternumModel;

/** Observables of structures that a scene lacks, or of which it has no motion: they are unknown, not 0. */
public final class UnknownObservables {
    private static final List<String> OF_LIVER = List.of("liver_si_mm", "liver_ap_mm", "liver_lr_mm");
    private static final List<String> OF_LUNGS = List.of("lung_volume_change_ml");
    private static final List<String> OF_STERNUM = List.of("ap_change_mm", "sternum_cranial_mm", "sternum_ventral_mm");
    private static final String WIDTH = "transverse_change_mm";

    private UnknownObservables() {}

    /** Columns of {@link Observation} that are NaN in a scene. */
    public static Set<String> of(Scene scene) {
        Set<String> unknown = new LinkedHashSet<>();
        if (scene.liver().filter(LiverPart::isCarried).isEmpty()) {
            unknown.addAll(OF_LIVER);
        }
        if (scene.lungs().isEmpty() && scene.embeddedLungs().isEmpty()) {
            unknown.addAll(OF_LUNGS);
        }
        boolean sternum = !scene.thorax().structuresOf(StructureKind.STERNUM).isEmpty();
        boolean isLed = scene.pose().cage().sternum() != RibCage.TRUNK;
        boolean standsStill = scene.settings().get(OrganSettings.STERNUM) == SternumModel.OFF;
        if (!sternum || (!isLed && !standsStill)) {
            unknown.addAll(OF_STERNUM);
        }
        if (!CageMeasure.hasWidth(scene.thorax())) {
            unknown.add(WIDTH);
        }
        return unknown;
    }
}
