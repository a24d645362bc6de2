package org.phrenic.study.measure;

import java.util.Map;
import org.phrenic.simulation.observe.Frame;

/** Computes observables from the surfaces of a scene. */
interface SceneMeasure {
    /**
     * Adds the observables of a frame. Observables of structures that the body lacks are left out.
     *
     * @param view geometry, already updated to the frame
     * @param values receives the values by name of the observable
     */
    void measure(SceneGeometry view, Frame frame, Map<String, Double> values);
}
