package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.LungPart;

/**
 * The space that lungs cannot leave: the box about ribs and lungs at rest, widened to the front, the back, the sides
 * and above by more than a deep breath moves any rib. A lung that comes out of it has folded or been thrown through the
 * cage, which no breath does. Below, the diaphragm sets no fixed limit.
 */
final class ChestBox {
    /** Distance from the box of ribs and lungs at rest, mm. A full inspiration moves a rib by up to 30 mm. */
    private static final double MARGIN_MM = 50;

    private ChestBox() {}

    /** Lets a stepper notice lungs that leave the chest. Does nothing without lungs of springs. */
    static void confineLungs(Scene scene, Stepper stepper) {
        scene.lungs().ifPresent(lungs -> stepper.confine(lungs.nodes().toArray(), box(scene, lungs), "the chest"));
    }

    private static double[] box(Scene scene, LungPart lungs) {
        List<Structure> inside = new ArrayList<>(scene.thorax().structuresOf(StructureKind.RIB));
        inside.addAll(lungs.structures);
        double[] box = BoundingBoxes.of(inside.stream().map(Structure::mesh));
        for (int axis = 0; axis < 3; axis++) {
            box[axis] -= MARGIN_MM;
            box[3 + axis] += MARGIN_MM;
        }
        box[2] = Double.NEGATIVE_INFINITY;
        return box;
    }
}
