package org.phrenic.model.material;

import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.force.Attachments;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;

/**
 * Springs that return the paper's sheet to its rest shape after a breath, because that model has neither abdominal
 * pressure nor bending stiffness. Every node is tied to its rest position by a weak spring: soft enough that the action
 * lines move the dome, fast enough (6 1/s) to follow a breath.
 */
final class RestoringSprings extends ScenePart {
    private static final double SHARE = 0.25;

    RestoringSprings() {
        super(Stage.BOUNDARY);
    }

    @Override
    public void addTo(Scene scene) {
        DiaphragmPart diaphragm = scene.diaphragm();
        int[] free = MassSpringBuilder.offset(diaphragm.freeVertices(), diaphragm.firstNode);
        double[] stiffness = new double[free.length];
        Arrays.fill(stiffness, SHARE * scene.settings().get(SheetSprings.SPRING_STIFFNESS));
        PrescribedMotion still =
                PrescribedMotion.stationary(MassSpringBuilder.positionsOf(scene.restPositions(), 0, free));
        Attachments springs = new Attachments(scene.layout(), free, stiffness, 0, still);
        scene.system().add(springs);
        BoneAttachments.tune(scene, springs, List.of(SheetSprings.SPRING_STIFFNESS), false);
    }
}
