package org.phrenic.model.material;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.SettingValues;

/**
 * The model of Villard, Bourne and Bello 2009: uniform spring stiffness, uniform node mass and muscle force along
 * action lines.
 */
class PaperMaterial extends TissueMaterial {
    private static final double TIME_STEP_S = 0.01;
    private static final double LUNG_TO_MUSCLE = 0.1;
    /** Displacement crosses the sheet by diffusion where damping outweighs inertia, and swings for longer if not. */
    private static final double HELD_REST_S = 30;

    PaperMaterial() {
        this("paper");
    }

    PaperMaterial(String label) {
        super(
                label,
                List.of(
                        new SheetSprings(SheetSprings.SPRING_STIFFNESS, false),
                        TissueMass.PER_NODE,
                        new ActionLines(),
                        new RibRotation(),
                        new BoneAttachments(SheetSprings.SPRING_STIFFNESS),
                        new RestoringSprings(),
                        new Lungs(SheetSprings.SPRING_STIFFNESS),
                        new Breathing(),
                        new PassiveSprings(SheetSprings.SPRING_STIFFNESS),
                        new RigidTendon()));
    }

    @Override
    public double defaultOf(Parameter parameter, SettingValues values) {
        return parameter == SheetSprings.TENDON_RATIO ? 1 : super.defaultOf(parameter, values);
    }

    /**
     * Störmer's formula. Motion is smooth on the scale of a step, so its error is a fifth of that of velocity Verlet.
     */
    @Override
    public IntegratorKind integrator() {
        return IntegratorKind.STORMER;
    }

    @Override
    public double timeStepS() {
        return TIME_STEP_S;
    }

    @Override
    public int projectionSweeps() {
        return 1;
    }

    /** No limit: the force along the action lines is unbounded. */
    @Override
    public double maxDisplacementMm() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public double heldRestS() {
        return HELD_REST_S;
    }

    @Override
    public TissueLaw tissueLaw(SettingValues values) {
        return TissueLaw.uniform(values.get(SheetSprings.SPRING_STIFFNESS), values.get(TissueMass.NODE_MASS));
    }

    @Override
    public double lungToMuscleStiffness(SettingValues values) {
        return LUNG_TO_MUSCLE;
    }

    @Override
    public DiaphragmPart diaphragm(Scene scene, Diaphragm diaphragm, TissueLaw law) {
        double ratio = scene.settings().get(SheetSprings.TENDON_RATIO);
        int links = scene.settings().get(RigidTendon.LINKS_PER_NODE);
        double[] noCrura = new double[diaphragm.sheet().vertexCount()];
        DiaphragmPart.Tissue tissue = new DiaphragmPart.Tissue(law, ratio, links, false, noCrura, 1, 1);
        return new DiaphragmPart(diaphragm, tissue, scene.nodes());
    }

    @Override
    public Optional<MovingChestWall> chestWall(Scene scene, List<Structure> lungs) {
        return Optional.empty();
    }

    @Override
    public double[] leastMasses(Scene scene, double[] positions) {
        return new double[positions.length / 3];
    }
}
