package org.phrenic.model.material;

import java.util.List;
import org.phrenic.engine.force.Springs;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TissueTuner;
import org.phrenic.model.assembly.TunableSprings;
import org.phrenic.model.organ.SpringList;
import org.phrenic.parameter.Parameter;

/** Springs of sternum, cartilages and lungs. */
final class PassiveSprings extends ScenePart {
    private final List<Parameter> stiffness;

    /** @param stiffness of muscle, and of the lungs if they have their own */
    PassiveSprings(Parameter... stiffness) {
        super(Stage.SPRINGS);
        this.stiffness = List.of(stiffness);
    }

    @Override
    public void addTo(Scene scene) {
        SpringList list = scene.nodes().passiveSprings;
        if (list.count() == 0) {
            return;
        }
        Springs springs = Springs.between(scene.layout(), list.nodeA(), list.nodeB())
                .stiffness(list.stiffness())
                .restLengths(list.rest())
                .build();
        scene.addPassive(springs);
        scene.tunes(stiffness, () -> tuning(scene, springs));
    }

    private static TissueTuner.Action tuning(Scene scene, Springs springs) {
        TunableSprings tunable = new TunableSprings(springs, scene.layout(), scene.restPositions());
        int firstLungNode = scene.firstLungNode();
        return (value, assembled, asAssembled) -> {
            if (asAssembled) {
                tunable.restoreAssembled();
                return;
            }
            double muscle = value[0] / assembled[0];
            double lung = lungFactor(value, assembled);
            for (int e = 0; e < tunable.count; e++) {
                boolean ofLung = tunable.nodes[2 * e] >= firstLungNode || tunable.nodes[2 * e + 1] >= firstLungNode;
                tunable.set(e, ofLung ? lung : muscle, 0);
            }
            tunable.apply();
        };
    }

    /**
     * Stiffness factor of the lungs relative to assembly: from their own stiffness (index 1) if they have one,
     * otherwise from that of muscle (index 0).
     */
    static double lungFactor(double[] value, double[] assembled) {
        int own = value.length > 1 ? 1 : 0;
        return value[own] / assembled[own];
    }
}
