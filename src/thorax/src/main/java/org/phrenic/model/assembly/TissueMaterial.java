package org.phrenic.model.assembly;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.SettingValues;

/**
 * What the springs of a scene stand for: the parts that act on its nodes with their parameters, how tissue becomes
 * springs and masses, and how it is stepped where a scenario does not say.
 */
public abstract class TissueMaterial {
    private final String label;
    private final List<ScenePart> parts;
    private final Set<Parameter> parameters = new LinkedHashSet<>();

    public TissueMaterial(String label, List<ScenePart> parts) {
        this.label = label;
        this.parts = List.copyOf(parts);
        parts.forEach(part -> parameters.addAll(part.parameters()));
    }

    /** Name in scenario files. */
    public final String label() {
        return label;
    }

    /** What acts on the nodes, in the order in which its parameters are documented. */
    public final List<ScenePart> parts() {
        return parts;
    }

    /** The parameters of its parts. */
    public final List<Parameter> parameters() {
        return List.copyOf(parameters);
    }

    /** Whether a part of it uses a parameter. */
    public final boolean uses(Parameter parameter) {
        return parameters.contains(parameter);
    }

    /** Value of a parameter where a scenario states none; NaN if no part uses it. */
    public double defaultOf(Parameter parameter, SettingValues values) {
        return uses(parameter) ? parameter.defaultValue(values) : Double.NaN;
    }

    /** Scheme where a scenario names none. */
    public abstract IntegratorKind integrator();

    /** Time step where a scenario gives none, s. */
    public abstract double timeStepS();

    /** Sweeps over all constraints a step where a scenario gives none. */
    public abstract int projectionSweeps();

    /** How far from rest a node may go before the run counts as diverged, mm; infinite for no limit. */
    public abstract double maxDisplacementMm();

    /** How tissue becomes springs and masses. */
    public abstract TissueLaw tissueLaw(SettingValues values);

    /** Stiffness of the lungs as a multiple of relaxed muscle's. */
    public abstract double lungToMuscleStiffness(SettingValues values);

    /** The diaphragm's nodes and springs. */
    public abstract DiaphragmPart diaphragm(Scene scene, Diaphragm diaphragm, TissueLaw law);

    /** The wall on which diaphragm and lungs slide; empty where attachments alone hold them. */
    public abstract Optional<MovingChestWall> chestWall(Scene scene, List<Structure> lungs);

    /** Makes nodes heavier that alone would shorten the time step; returns the mass added, per cent. */
    public abstract double scaleMasses(Scene scene, double[] positions, double[] masses);

    @Override
    public String toString() {
        return label;
    }
}
