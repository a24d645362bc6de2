package org.phrenic.model.material;

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
public final class SheetSprings implements ScenePart {
    public static final Parameter MUSCLE_STIFFNESS = Parameter.named("muscle_stiffness_n_per_m", "Muscle stiffness")
            .unit("N/m")
            .range(30, 3000)
            .initial(300)
            .group(Group.MUSCLE)
            .limitsStep()
            .fitted(100, 450)
            .describedAs("Membrane stiffness E h of the whole sheet in muscle.");
    public static final Parameter TENDON_RATIO = Parameter.named("tendon_stiffness_ratio", "Tendon to muscle")
            .range(1, 50)
            .initial(10)
            .limitsStep()
            .fitted(2, 20)
            .describedAs("Stiffness of the central tendon as a multiple of the muscle's; 5 to 10 make it all but"
                    + " inextensible in a breath.");
    public static final Parameter SPRING_STIFFNESS = Parameter.named("spring_stiffness_n_per_m", "Spring stiffness")
            .unit("N/m")
            .range(1, 500)
            .initial(15)
            .limitsStep()
            .describedAs("One stiffness k for every spring (Villard, Bourne and Bello 2009).");

    private final Parameter stiffness;
    private final boolean contractile;

    /** @param contractile whether muscle shortens and prestress balances the pressure */
    SheetSprings(Parameter stiffness, boolean contractile) {
        this.stiffness = stiffness;
        this.contractile = contractile;
    }

    @Override
    public Stage stage() {
        return Stage.SPRINGS;
    }

    @Override
    public List<Parameter> parameters() {
        return contractile ? List.of(stiffness, TENDON_RATIO) : List.of(TENDON_RATIO, stiffness);
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
        if (contractile) {
            scene.tunes(
                    List.of(
                            stiffness,
                            TENDON_RATIO,
                            TransdiaphragmaticPressure.REST_PRESSURE,
                            Muscle.LEFT_OVER_RIGHT,
                            Muscle.FRONT_OVER_BACK),
                    () -> contractileTuning(scene));
        } else {
            scene.tunes(List.of(stiffness, TENDON_RATIO), () -> passiveTuning(scene));
        }
    }

    private static TissueTuner.Action contractileTuning(Scene scene) {
        TunableSprings springs = scene.tunable(scene.sheetSprings());
        RestPressure pressure = scene.restPressure();
        return (value, assembled, asAssembled) -> {
            pressure.scaleLoad(value[2]);
            if (asAssembled) {
                springs.restoreAssembled();
                return;
            }
            for (int e = 0; e < springs.count; e++) {
                setStiffness(springs, e, scene.diaphragm(), value, assembled, pressure.additionalTension(e, value[2]));
                setShortening(springs, e, scene.diaphragm().contractileShare(e, value[3], value[4]));
            }
            springs.apply();
        };
    }

    private static TissueTuner.Action passiveTuning(Scene scene) {
        TunableSprings springs = scene.tunable(scene.sheetSprings());
        return (value, assembled, asAssembled) -> {
            if (asAssembled) {
                springs.restoreAssembled();
                return;
            }
            for (int e = 0; e < springs.count; e++) {
                setStiffness(springs, e, scene.diaphragm(), value, assembled, 0);
                setShortening(springs, e, scene.diaphragm().contractileShare(e, 1, 1));
            }
            springs.apply();
        };
    }

    private static void setStiffness(
            TunableSprings springs, int e, DiaphragmPart sheet, double[] value, double[] assembled, double tension) {
        double muscle = value[0] / assembled[0];
        double tendon = muscle * (value[1] / assembled[1]);
        springs.set(e, sheet.isTendonEdge(e) ? tendon : muscle, tension);
    }

    private static void setShortening(TunableSprings springs, int e, double share) {
        springs.shortening[e] = share * RestPressure.limitedRestLength(springs.lengthAtRest[e], springs.restLength[e]);
    }
}
