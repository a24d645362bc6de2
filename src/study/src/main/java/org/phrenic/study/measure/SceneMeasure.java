package org.phrenic.study.measure;

import java.util.Map;
import org.phrenic.simulation.observe.Frame;

/** Something that is measured on a scene's surfaces. */
interface SceneMeasure {
    /**
     * Writes what it finds at this time; what the body lacks is left out.
     *
     * @param view shows the frame
     * @param values by name of the observable
     */
    void measure(SceneGeometry view, Frame frame, Map<String, Double> values);
}
