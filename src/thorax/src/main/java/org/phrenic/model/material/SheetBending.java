package org.phrenic.model.material;

import java.util.List;
import org.phrenic.engine.force.HingeBending;
import org.phrenic.engine.force.Hinges;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TissueTuner;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.SheetHinges;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Setting;

/**
 * Resistance of the diaphragm's muscle to bending. A plate of thickness h that is stretched by a membrane stiffness E h
 * has the bending stiffness D = E h · h² / 12 (1 - ν²), in proportion to E h. The default, 0.25 N mm, is that of 300
 * N/m and 3 mm, the thickness of which membrane stiffness and mass per area are; 1.9 mm, that of the zone of apposition
 * at end-expiration in ultrasound, have 0.1 N mm, and 5 mm have 0.7.
 */
public final class SheetBending extends ScenePart {
    private static final double STIFFNESS_N_MM = 0.25;

    public static final NumberSetting BENDING_STIFFNESS = Setting.named(
                    "bending_stiffness_n_mm", "Bending stiffness", Effect.ASSEMBLY)
            .describedAs(
                    "Physical material: bending stiffness of the diaphragm's muscle where its membrane stiffness E h"
                            + " is 300 N/m, in proportion to that otherwise; E h (thickness)² / 11 of a plate.")
            .number("N mm", 0, 10, values -> STIFFNESS_N_MM);

    private static final double MILLI = 1000;

    SheetBending() {
        super(Stage.SPRINGS);
    }

    @Override
    public void addTo(Scene scene) {
        double stiffness = stiffness(scene);
        if (stiffness > 0) {
            double[] rest = scene.restPositions();
            HingeBending bending = new HingeBending(scene.layout(), hinges(scene.diaphragm(), rest, stiffness), rest);
            scene.system().add(bending);
            scene.tunes(List.of(SheetSprings.MUSCLE_STIFFNESS), () -> tuning(scene, bending));
        }
    }

    /** The rest shape stays: forces are those of assembly where the scene has settled. */
    private static TissueTuner.Action tuning(Scene scene, HingeBending bending) {
        bending.keepForcesAt(scene.layout().toInternal(scene.restPositions()));
        return (value, assembled, asAssembled) -> bending.setScale(value[0] / assembled[0]);
    }

    /** Bending stiffness at the assembled muscle stiffness, N mm. */
    private static double stiffness(Scene scene) {
        double ofUsual = scene.settings().get(SheetSprings.MUSCLE_STIFFNESS) / SheetSprings.USUAL_MUSCLE_STIFFNESS;
        return ofUsual * scene.settings().get(BENDING_STIFFNESS);
    }

    /**
     * Adds the bending stiffness to what the masses of nodes are scaled for: row sums, which bound it in all directions
     * and on any mesh.
     */
    static void addTo(MassScaling scaling, Scene scene, double[] positions) {
        double stiffness = stiffness(scene);
        if (stiffness > 0) {
            Hinges hinges = hinges(scene.diaphragm(), positions, stiffness);
            scaling.addAttachments(hinges.corners(), hinges.rowSums(), 1);
        }
    }

    /** Hinges of a sheet whose bending stiffness is given in N mm. */
    static Hinges hinges(DiaphragmPart sheet, double[] positions, double newtonMm) {
        return SheetHinges.of(sheet, positions, MILLI * newtonMm);
    }
}
