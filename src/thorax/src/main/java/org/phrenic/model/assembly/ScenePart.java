package org.phrenic.model.assembly;

import java.util.List;
import org.phrenic.parameter.Parameter;

/**
 * A force, constraint or drive that acts on the nodes of a scene, with the parameters that it uses. A part holds no
 * state of a scene: one object serves all scenes of a material. What it adds to a scene reads its values from the
 * {@link org.phrenic.parameter.RampedValue}s of that scene.
 */
public interface ScenePart {
    /**
     * Order in which parts are added. Forces are summed in this order, and the last bit of a floating-point sum depends
     * on it.
     */
    enum Stage {
        BOUNDARY,
        PRESSURE,
        SPRINGS,
        ACTION_LINES,
        CONSTRAINTS,
        LUNGS,
        LOADS
    }

    /** Stage of this part. Parts of one stage are added in the order in which the material lists them. */
    default Stage stage() {
        return Stage.LOADS;
    }

    /** The parameters that it declares. */
    default List<Parameter> parameters() {
        return List.of();
    }

    /**
     * Adds forces and constraints to a scene whose nodes exist. The default does nothing, for parts that only declare
     * parameters.
     */
    default void addTo(Scene scene) {}
}
