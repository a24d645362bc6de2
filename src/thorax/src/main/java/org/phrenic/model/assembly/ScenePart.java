package org.phrenic.model.assembly;

import java.util.List;
import org.phrenic.parameter.Parameter;

/**
 * A force, constraint or drive that acts on the nodes of a scene, with the parameters that it uses. A part holds no
 * state of a scene: one object serves all scenes of a material. What it adds to a scene reads its values from the
 * {@link org.phrenic.parameter.RampedValue}s of that scene.
 */
public abstract class ScenePart {
    /**
     * Order in which parts are added. Forces are summed in this order, and the last bit of a floating-point sum depends
     * on it.
     */
    public enum Stage {
        BOUNDARY,
        PRESSURE,
        SPRINGS,
        ACTION_LINES,
        CONSTRAINTS,
        LUNGS,
        LOADS
    }

    private final Stage stage;
    private final List<Parameter> parameters;

    /** @param parameters that the part declares */
    protected ScenePart(Stage stage, Parameter... parameters) {
        this.stage = stage;
        this.parameters = List.of(parameters);
    }

    /** Stage of this part. Parts of one stage are added in the order in which the material lists them. */
    public final Stage stage() {
        return stage;
    }

    /** The parameters that it declares. */
    public final List<Parameter> parameters() {
        return parameters;
    }

    /**
     * Adds forces and constraints to a scene whose nodes exist. The default does nothing, for parts that only declare
     * parameters.
     */
    public void addTo(Scene scene) {}
}
