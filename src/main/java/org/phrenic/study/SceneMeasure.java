package org.phrenic.study;

import java.util.Map;
import org.phrenic.simulation.Frame;

/** Something that is measured on a scene's surfaces. */
interface SceneMeasure {
    /**
     * Writes what it finds at this time; what the body lacks is left out.
     *
     * @param view shows the frame
     * @param values by name of the observable
     */
    void at(SceneView view, Frame frame, Map<String, Double> values);
}
