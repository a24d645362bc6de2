package org.phrenic.model.material;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.CruralOrigin;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.mesh.query.SurfaceSamples;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;

/**
 * Membrane under transdiaphragmatic pressure: stiffness, mass and damping per unit of area, contractile muscle, and a
 * chest wall on which diaphragm and lungs slide.
 */
final class PhysicalMaterial extends TissueMaterial {
    /**
     * Mass of a lung's node over the least for its springs in any shape. A spring that is pressed to nothing in a fold
     * turns at every step; its force then kicks the node by an impulse that only mass opposes.
     */
    private static final double LUNG_MARGIN = 2;

    private static final double TIME_STEP_S = 0.00125;
    /**
     * Contact and non-inversion constraints share nodes. After three Gauss-Seidel sweeps the residual is below a
     * thousandth of an excursion.
     */
    private static final int SWEEPS = 3;
    /**
     * No point of the trunk moves this far. A soft sheet under the largest pressure and without a wall would, because
     * its force law has no limit.
     */
    private static final double MAX_DISPLACEMENT_MM = 200;
    /** Time after which a held breath is near rest, s; docs/fit.md states how near. */
    private static final double HELD_REST_S = 0.9;

    PhysicalMaterial() {
        super(
                "physical",
                List.of(
                        new SheetSprings(SheetSprings.MUSCLE_STIFFNESS, true),
                        new SheetBending(),
                        TissueMass.PER_AREA,
                        new Muscle(),
                        new TransdiaphragmaticPressure(),
                        new RibRotation(),
                        new BoneAttachments(SheetSprings.MUSCLE_STIFFNESS, Lungs.LUNG_STIFFNESS),
                        new Lungs(SheetSprings.MUSCLE_STIFFNESS, Lungs.LUNG_STIFFNESS),
                        new Mediastinum(),
                        new Gravity(),
                        new Breathing(),
                        new PassiveSprings(SheetSprings.MUSCLE_STIFFNESS, Lungs.LUNG_STIFFNESS),
                        new RigidTendon(),
                        new WallContact()));
    }

    @Override
    public List<Setting<?>> settings() {
        return List.of(
                Numerics.MASS_SCALING,
                Numerics.TENDON_LIGHTNESS,
                Numerics.DAMPING_TIME,
                SheetBending.BENDING_STIFFNESS);
    }

    @Override
    public IntegratorKind integrator() {
        return IntegratorKind.VERLET;
    }

    @Override
    public double timeStepS() {
        return TIME_STEP_S;
    }

    @Override
    public int projectionSweeps() {
        return SWEEPS;
    }

    @Override
    public double maxDisplacementMm() {
        return MAX_DISPLACEMENT_MM;
    }

    @Override
    public double heldRestS() {
        return HELD_REST_S;
    }

    @Override
    public TissueLaw tissueLaw(SettingValues values) {
        return TissueLaw.membrane(values.get(SheetSprings.MUSCLE_STIFFNESS), values.get(TissueMass.AREA_DENSITY));
    }

    @Override
    public double lungToMuscleStiffness(SettingValues values) {
        return values.get(Lungs.LUNG_STIFFNESS) / values.get(SheetSprings.MUSCLE_STIFFNESS);
    }

    @Override
    public DiaphragmPart diaphragm(Scene scene, Diaphragm diaphragm, TissueLaw law) {
        SettingValues values = scene.settings();
        DiaphragmPart.Tissue tissue = new DiaphragmPart.Tissue(
                law,
                values.get(SheetSprings.TENDON_RATIO),
                values.get(RigidTendon.LINKS_PER_NODE),
                true,
                CruralOrigin.attachmentShares(scene.thorax(), diaphragm),
                values.get(Muscle.LEFT_OVER_RIGHT),
                values.get(Muscle.FRONT_OVER_BACK));
        return new DiaphragmPart(diaphragm, tissue, scene.nodes());
    }

    @Override
    public Optional<MovingChestWall> chestWall(Scene scene, List<Structure> lungs) {
        Diaphragm sheet = scene.diaphragm().diaphragm;
        SurfaceSamples contents = new SurfaceSamples(MovingChestWall.MAX_SPACING_MM);
        for (int t = 0; t < sheet.sheet().triangleCount(); t++) {
            if (sheet.isThoracicTriangle(t)) {
                contents.add(sheet.sheet(), t);
            }
        }
        lungs.forEach(lung -> contents.add(lung.mesh()));
        double[] box = sheet.sheet().bounds();
        double x = 0.5 * (box[0] + box[3]);
        double y = 0.5 * (box[1] + box[4]);
        return Optional.of(new MovingChestWall(contents.points(), x, y, scene.bones(), scene.pose(), scene.workers()));
    }

    @Override
    public double[] leastMasses(Scene scene, double[] positions) {
        MassSpringBuilder nodes = scene.nodes();
        MassScaling scaling = new MassScaling(positions);
        scaling.addSprings(nodes.sheetSprings);
        scaling.addSprings(nodes.passiveSprings);
        scaling.addAttachments(
                nodes.attachedNodes(),
                nodes.attachedStiffnesses(),
                scene.settings().get(BoneAttachments.STERNUM_COUPLING));
        scaling.addAttachments(scene.diaphragm().cruralNodes, scene.diaphragm().cruralStiffnesses, 1);
        scene.lungs().ifPresent(l -> scaling.addAttachments(l.baseSprings.node(), l.baseSprings.stiffnesses(), 1));
        SheetBending.addTo(scaling, scene, positions);
        double step = scene.settings().get(Numerics.MASS_SCALING) / Stepper.SAFETY;
        double[] least = scaling.leastMasses(step);
        // In a deep breath lungs fold at their edges; nothing that is observed of the diaphragm depends on their mass.
        scene.lungs().ifPresent(lungs -> lungs.nodes()
                .forEach(n -> least[n] = LUNG_MARGIN * scaling.leastMassForAnyShape(n, step)));
        return least;
    }
}
