package org.phrenic.study.measure;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.observe.Frame;

/**
 * Observables that the physiology table needs in addition to those of every run, computed from the surfaces of a scene.
 */
public final class SceneObservables {
    private record Group(List<String> names, Function<SceneGeometry, SceneMeasure> make) {}

    private static final List<Group> GROUPS = List.of(
            new Group(RibMeasure.NAMES, RibMeasure::new),
            new Group(DomeLevelMeasure.NAMES, DomeLevelMeasure::new),
            new Group(DiaphragmSectionMeasure.NAMES, DiaphragmSectionMeasure::new),
            new Group(AppositionMeasure.NAMES, AppositionMeasure::new),
            new Group(DiaphragmAreaMeasure.NAMES, DiaphragmAreaMeasure::new),
            new Group(TissueStrainMeasure.NAMES, TissueStrainMeasure::new),
            new Group(LiverSternumMeasure.NAMES, LiverSternumMeasure::new),
            new Group(CageDimensions.NAMES, CageDimensions::new));

    private final SceneGeometry view;
    private final List<String> names = new ArrayList<>();
    private final List<SceneMeasure> measures = new ArrayList<>();
    private final Map<String, Double> values = new LinkedHashMap<>();

    /**
     * Prepares the measures of the requested observables.
     *
     * @param surfaces of the scene at rest
     * @param sheet the diaphragm of the scene
     * @param wanted names of observables; unknown names are ignored
     */
    public SceneObservables(SceneSurfaces surfaces, Diaphragm sheet, Frame rest, Collection<String> wanted) {
        view = new SceneGeometry(surfaces.surfaces(), sheet);
        view.update(rest);
        for (Group group : GROUPS) {
            if (group.names.stream().anyMatch(wanted::contains)) {
                names.addAll(group.names);
                measures.add(group.make.apply(view));
            }
        }
    }

    /** Names of all observables. */
    public static List<String> names() {
        return GROUPS.stream().flatMap(g -> g.names.stream()).toList();
    }

    /** Column names of {@link #measure}. */
    public List<String> columns() {
        return List.copyOf(names);
    }

    /** One value per column; NaN if the body lacks the structure. */
    public double[] measure(Frame frame) {
        view.update(frame);
        values.clear();
        measures.forEach(measure -> measure.measure(view, frame, values));
        return names.stream()
                .mapToDouble(name -> values.getOrDefault(name, Double.NaN))
                .toArray();
    }
}
