package org.phrenic.model.material;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.FallOff;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.TunableAttachments;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;

/**
 * Attachments of nodes to bone. The insertion of the diaphragm follows bone exactly; the origin of the crura, sternum,
 * cartilages and lungs are attached by springs to anchors on bone.
 */
public final class BoneAttachments extends ScenePart {
    public static final Parameter STERNUM_COUPLING = Parameter.named("sternum_coupling", "Sternum coupling")
            .range(0, 10)
            .initial(1)
            .group(Group.RIBS)
            .limitsStep()
            .fitted(0.3, 3)
            .describedAs(
                    "Multiplies the springs that hold sternum, cartilages and lungs to bone, not those of the crura.");

    /**
     * Decay length of the paper's attachments around the insertion, and their low stiffness as a share of a spring's.
     */
    private static final double INSERTION_MM = 25;

    private static final double INSERTION_SHARE = 0.1;

    private final List<Parameter> stiffness;
    private final boolean besideInsertion;

    /** For a sheet held by pressure and crura: stiffness of muscle and of the lungs. */
    BoneAttachments(Parameter muscle, Parameter lungs) {
        super(Stage.BOUNDARY, STERNUM_COUPLING);
        stiffness = List.of(muscle, lungs);
        besideInsertion = false;
    }

    /** For the paper's sheet, which is also attached around its insertion: the stiffness of all springs. */
    BoneAttachments(Parameter springs) {
        super(Stage.BOUNDARY, STERNUM_COUPLING);
        stiffness = List.of(springs);
        besideInsertion = true;
    }

    @Override
    public void addTo(Scene scene) {
        int[] inserted = prescribeInsertion(scene);
        if (besideInsertion) {
            attachBesideInsertion(scene);
        }
        addCrura(scene);
        int[] attached = addAnchoredSprings(scene);
        scene.holdNodes(MassSpringBuilder.concatenate(inserted, attached));
    }

    private static int[] prescribeInsertion(Scene scene) {
        DiaphragmPart diaphragm = scene.diaphragm();
        int[] inserted = diaphragm.insertedVertices();
        if (inserted.length == 0) {
            throw new BadInputException(scene.thorax().name()
                    + ": the diaphragm has no border that bone could hold, expected a"
                    + " sheet whose two faces meet at its insertion");
        }
        double[] rim = MassSpringBuilder.positionsOf(scene.restPositions(), diaphragm.firstNode, inserted);
        int[] nodes = MassSpringBuilder.offset(inserted, diaphragm.firstNode);
        scene.system().prescribe(nodes, onBone(scene, rim));
        return nodes;
    }

    private static PrescribedMotion onBone(Scene scene, double[] points) {
        return new LinearBlendSkinning(scene.pose(), points, scene.bones().weightsAt(points), scene.workers());
    }

    private void attachBesideInsertion(Scene scene) {
        Diaphragm sheet = scene.diaphragm().diaphragm;
        for (int i = 0; i < sheet.sheet().vertexCount(); i++) {
            double fade = FallOff.at(sheet.distanceFromInsertion(i), INSERTION_MM);
            if (fade > 0 && !sheet.isInserted(i)) {
                double held = INSERTION_SHARE * scene.settings().get(stiffness.get(0)) * fade;
                scene.nodes().attachToBone(scene.diaphragm().firstNode + i, held);
            }
        }
    }

    /** Attaches the crura to the spine, which does not move. */
    private static void addCrura(Scene scene) {
        int[] crural = scene.diaphragm().cruralNodes;
        if (crural.length > 0) {
            PrescribedMotion still =
                    PrescribedMotion.stationary(MassSpringBuilder.positionsOf(scene.restPositions(), 0, crural));
            scene.system().add(new Attachments(scene.layout(), crural, scene.diaphragm().cruralStiffnesses, 0, still));
        }
    }

    /**
     * Adds the springs to bone and returns their nodes, in memory order, so that anchors need no sorting at every
     * refresh.
     */
    private int[] addAnchoredSprings(Scene scene) {
        int[] listed = scene.nodes().attachedNodes();
        int[] order = scene.layout().inMemoryOrder(listed);
        int[] attached = Arrays.stream(order).map(i -> listed[i]).toArray();
        if (attached.length == 0) {
            return attached;
        }
        double[] each = scene.nodes().attachedStiffnesses();
        double[] anchors = MassSpringBuilder.positionsOf(scene.restPositions(), 0, attached);
        double[] ordered = Arrays.stream(order).mapToDouble(i -> each[i]).toArray();
        Attachments springs = new Attachments(scene.layout(), attached, ordered, 0, onBone(scene, anchors));
        springs.setRefreshInterval(scene.refreshS());
        springs.setStiffnessFactor(scene.settings().get(STERNUM_COUPLING));
        scene.system().add(springs);
        tune(scene, springs, stiffness, true);
        return attached;
    }

    /**
     * Scales attachments with the stiffness of muscle and of the lungs, the first and last of {@code stiffness}, and,
     * if they are coupled, with {@link #STERNUM_COUPLING}.
     */
    static void tune(Scene scene, Attachments springs, List<Parameter> stiffness, boolean coupled) {
        List<Parameter> parameters = new ArrayList<>(stiffness);
        parameters.add(STERNUM_COUPLING);
        scene.tunes(parameters, () -> {
            TunableAttachments tunable = new TunableAttachments(springs, scene.restPositions(), scene.firstLungNode());
            int lung = stiffness.size() - 1;
            return (value, assembled, asAssembled) -> tunable.tune(
                    asAssembled, value[0] / assembled[0], value[lung] / assembled[lung], coupled ? value[lung + 1] : 1);
        });
    }
}
