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
import org.phrenic.model.organ.TendonRule;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;

/**
 * Material model of a scene: the parts that act on its nodes with their parameters, the mapping from tissue to springs
 * and masses, and the default integration settings.
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

    /** Parts that act on the nodes, in the order in which their parameters are documented. */
    public final List<ScenePart> parts() {
        return parts;
    }

    /** Parameters of all parts. */
    public final List<Parameter> parameters() {
        return List.copyOf(parameters);
    }

    /** Settings besides the parameters that this material reads and not every other does. */
    public List<Setting<?>> settings() {
        return List.of();
    }

    /** Whether it or one of its parts uses a setting of a material. */
    public final boolean uses(Setting<?> setting) {
        return setting instanceof Parameter parameter
                ? parameters.contains(parameter)
                : settings().contains(setting);
    }

    /** Default value of a parameter; NaN if no part uses it. */
    public double defaultOf(Parameter parameter, SettingValues values) {
        return uses(parameter) ? parameter.defaultValue(values) : Double.NaN;
    }

    /** Default integrator. */
    public abstract IntegratorKind integrator();

    /** Default time step, s. */
    public abstract double timeStepS();

    /** Default number of Gauss-Seidel sweeps over all constraints per step. */
    public abstract int projectionSweeps();

    /** Default division of the diaphragm into tendon and muscle. */
    public TendonRule tendonRule() {
        return TendonRule.TREFOIL;
    }

    /** Whether sternum and cartilages may make shorter steps than the other nodes. No force may act between the two. */
    public boolean stepsSternumApart() {
        return false;
    }

    /** Displacement from rest beyond which a run counts as diverged, mm; infinite for no limit. */
    public abstract double maxDisplacementMm();

    /** Time in which a breath that is held comes near rest, s. A fit observes it then. */
    public abstract double heldRestS();

    /** Mapping from tissue to springs and masses. */
    public abstract TissueLaw tissueLaw(SettingValues values);

    /** Stiffness of the lungs as a multiple of relaxed muscle's. */
    public abstract double lungToMuscleStiffness(SettingValues values);

    /** Creates the nodes and springs of the diaphragm. */
    public abstract DiaphragmPart diaphragm(Scene scene, Diaphragm diaphragm, TissueLaw law);

    /** The wall on which diaphragm and lungs slide; empty if attachments alone hold them. */
    public abstract Optional<MovingChestWall> chestWall(Scene scene, List<Structure> lungs);

    /** Least mass of each node for the time step that masses are scaled for, kg; 0 where the tissue's own stands. */
    public abstract double[] leastMasses(Scene scene, double[] positions);

    @Override
    public String toString() {
        return label;
    }
}
