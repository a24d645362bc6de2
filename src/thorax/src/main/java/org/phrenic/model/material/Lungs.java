package org.phrenic.model.material;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.Attachments;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LungBaseMotion;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.NodeFollowers;
import org.phrenic.parameter.Parameter;

/**
 * Holds the lungs in the chest: attaches their base to the diaphragm, along which it slides if there is a chest wall,
 * and keeps the pleura on that wall.
 */
public final class Lungs extends ScenePart {
    public static final Parameter LUNG_STIFFNESS = Parameter.named("lung_stiffness_n_per_m", "Lung stiffness")
            .range(0.1, 100, "N/m")
            .initial(5)
            .limitsStep()
            .fitted(1, 20)
            .describedAs("Stiffness of the lungs' surface, stated as for a sheet of two faces: twice its membrane"
                    + " stiffness.");

    private final List<Parameter> stiffness;

    /** @param stiffness of muscle, then {@link #LUNG_STIFFNESS} if the lungs have their own */
    Lungs(Parameter... stiffness) {
        super(Stage.LUNGS, Arrays.copyOfRange(stiffness, 1, stiffness.length));
        this.stiffness = List.of(stiffness);
    }

    @Override
    public void addTo(Scene scene) {
        scene.lungs().ifPresent(lungs -> {
            attachBase(scene, lungs);
            scene.wall().ifPresent(wall -> holdToPleura(scene, lungs, wall));
        });
    }

    /**
     * Attaches the base of the lungs to the diaphragm. It slides if there is a chest wall; otherwise it follows its
     * nodes.
     */
    private void attachBase(Scene scene, LungPart lungs) {
        int[] nodes = lungs.baseSprings.node();
        double[] points = MassSpringBuilder.positionsOf(scene.restPositions(), 0, nodes);
        DiaphragmPart sheet = scene.diaphragm();
        int[] nearest = MassSpringBuilder.offset(lungs.baseSprings.nearestVertex(), sheet.firstNode);
        PrescribedMotion places = scene.recessTracks()
                .<PrescribedMotion>map(tracks ->
                        new LungBaseMotion(scene.system(), sheet, scene.wall().orElseThrow(), points, tracks))
                .orElseGet(() -> new NodeFollowers(scene.system(), nearest, points));
        Attachments base = new Attachments(scene.layout(), nodes, lungs.baseSprings.stiffnesses(), 0, places);
        base.setRefreshInterval(scene.refreshS());
        scene.addLungBase(base);
        BoneAttachments.tune(scene, base, stiffness, false);
    }

    private static void holdToPleura(Scene scene, LungPart lungs, MovingChestWall wall) {
        int[] pleural = lungs.pleuralNodes();
        ContactSurface surface = wall.slidingContact(MassSpringBuilder.positionsOf(scene.restPositions(), 0, pleural));
        scene.system().add(SlidingContact.adhering(scene.layout(), pleural, surface, scene.refreshS()));
    }
}
