package org.phrenic.model.material;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.force.Springs;
import org.phrenic.model.assembly.RestPressure;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TissueTuner;
import org.phrenic.model.assembly.TunableSprings;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.SpringList;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;

/** Springs of the diaphragm along its edges and across its thickness, stiffer in the tendon. */
public final class SheetSprings extends ScenePart {
    /** Muscle stiffness unless a scenario states another, N/m. */
    static final double USUAL_MUSCLE_STIFFNESS = 300;

    public static final Parameter MUSCLE_STIFFNESS = Parameter.named("muscle_stiffness_n_per_m", "Muscle stiffness")
            .range(30, 3000, "N/m")
            .initial(USUAL_MUSCLE_STIFFNESS)
            .group(Group.MUSCLE)
            .limitsStep()
            .fitted(100, 450)
            .describedAs("Membrane stiffness E h of the whole sheet in muscle; bending stiffness goes with it.");
    public static final Parameter TENDON_RATIO = Parameter.named("tendon_stiffness_ratio", "Tendon to muscle")
            .range(1, 50)
            .initial(10)
            .limitsStep()
            .fitted(2, 20)
            .describedAs("Stiffness of the central tendon as a multiple of the muscle's; 5 to 10 make it all but"
                    + " inextensible in a breath.");
    public static final Parameter SPRING_STIFFNESS = Parameter.named("spring_stiffness_n_per_m", "Spring stiffness")
            .range(1, 500, "N/m")
            .initial(15)
            .limitsStep()
            .describedAs("One stiffness k for every spring (Villard, Bourne and Bello 2009).");

    private final Parameter stiffness;
    private final boolean contractile;

    /** @param contractile whether muscle shortens and prestress balances the pressure */
    SheetSprings(Parameter stiffness, boolean contractile) {
        super(
                Stage.SPRINGS,
                contractile ? new Parameter[] {stiffness, TENDON_RATIO} : new Parameter[] {TENDON_RATIO, stiffness});
        this.stiffness = stiffness;
        this.contractile = contractile;
    }

    @Override
    public void addTo(Scene scene) {
        SpringList list = scene.nodes().sheetSprings;
        Springs.Builder builder = Springs.between(scene.layout(), list.nodeA(), list.nodeB())
                .stiffness(list.stiffness())
                .restLengths(list.rest());
        if (contractile) {
            builder.contractileShares(list.contractileShare());
        }
        scene.addSheet(builder.build());
        List<Parameter> tuned = new ArrayList<>(List.of(stiffness, TENDON_RATIO));
        if (contractile) {
            Parameter pressure = TransdiaphragmaticPressure.REST_PRESSURE;
            tuned.addAll(List.of(pressure, Muscle.LEFT_OVER_RIGHT, Muscle.FRONT_OVER_BACK));
        }
        scene.tunes(tuned, () -> tuning(scene));
    }

    private TissueTuner.Action tuning(Scene scene) {
        TunableSprings springs = new TunableSprings(scene.sheetSprings(), scene.layout(), scene.restPositions());
        DiaphragmPart sheet = scene.diaphragm();
        RestPressure pressure = scene.restPressure();
        return (value, assembled, asAssembled) -> {
            if (contractile) {
                pressure.scaleLoad(value[2]);
            }
            if (asAssembled) {
                springs.restoreAssembled();
                return;
            }
            double muscle = value[0] / assembled[0];
            for (int e = 0; e < springs.count; e++) {
                double tension = contractile ? pressure.additionalTension(e, value[2]) : 0;
                springs.set(e, muscle * sheet.tendonFactor(e, value[1], assembled[1]), tension);
                double share = sheet.contractileShare(e, contractile ? value[3] : 1, contractile ? value[4] : 1);
                springs.shortening[e] =
                        share * RestPressure.limitedRestLength(springs.lengthAtRest[e], springs.restLength[e]);
            }
            springs.apply();
        };
    }
}
