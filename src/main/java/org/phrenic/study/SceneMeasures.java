package org.phrenic.study;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.SceneSurfaces;

/** Observables that the physiology table needs beyond those of {@link org.phrenic.simulation.Observation}, computed from where the surfaces of a scene are. */
public final class SceneMeasures {
    private record Group(List<String> names, Function<SceneView, SceneMeasure> make) {}

    private static final List<Group> GROUPS = List.of(
            new Group(RibMeasure.NAMES, RibMeasure::new),
            new Group(LevelMeasure.NAMES, LevelMeasure::new),
            new Group(SectionMeasure.NAMES, SectionMeasure::new),
            new Group(AppositionMeasure.NAMES, AppositionMeasure::new),
            new Group(SheetMeasure.NAMES, SheetMeasure::new),
            new Group(TissueMeasure.NAMES, TissueMeasure::new),
            new Group(OrganMeasure.NAMES, OrganMeasure::new),
            new Group(CageSize.NAMES, CageSize::new));

    private final SceneView view;
    private final List<String> names = new ArrayList<>();
    private final List<SceneMeasure> measures = new ArrayList<>();
    private final Map<String, Double> values = new LinkedHashMap<>();

    /**
     * Makes what is needed for some observables.
     *
     * @param surfaces of the scene at rest
     * @param wanted names of observables; those that are not of here are passed over
     */
    public SceneMeasures(SceneSurfaces surfaces, Frame rest, Collection<String> wanted) {
        view = new SceneView(surfaces.surfaces());
        view.show(rest);
        for (Group group : GROUPS) {
            if (group.names.stream().anyMatch(wanted::contains)) {
                names.addAll(group.names);
                measures.add(group.make.apply(view));
            }
        }
    }

    /** All names there are. */
    public static List<String> names() {
        return GROUPS.stream().flatMap(g -> g.names.stream()).toList();
    }

    /** Names of the columns of {@link #at}. */
    public List<String> columns() {
        return List.copyOf(names);
    }

    /** One value a column; NaN where the body lacks what is measured. */
    public double[] at(Frame frame) {
        view.show(frame);
        values.clear();
        measures.forEach(measure -> measure.at(view, frame, values));
        return names.stream()
                .mapToDouble(name -> values.getOrDefault(name, Double.NaN))
                .toArray();
    }
}
