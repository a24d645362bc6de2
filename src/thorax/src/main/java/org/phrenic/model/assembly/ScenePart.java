package org.phrenic.model.assembly;

import java.util.List;
import org.phrenic.parameter.Parameter;

/**
 * Something that acts on the nodes of a scene, and the parameters that it uses. A part holds no state of a scene: one
 * object serves all scenes of a material. What it adds to a scene reads its values from the
 * {@link org.phrenic.parameter.RampedValue}s that it takes from the builder.
 */
public interface ScenePart {
    /**
     * When parts are added. Forces are summed in the order in which they are added, and the last bit of a sum depends
     * on the order.
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

    /** When it is added; parts of one stage in the order in which the material lists them. */
    default Stage stage() {
        return Stage.LOADS;
    }

    /** The parameters that it declares. */
    default List<Parameter> parameters() {
        return List.of();
    }

    /** Adds what acts to a scene whose nodes are in place; nothing for a part that only declares parameters. */
    default void addTo(Scene scene) {}
}
