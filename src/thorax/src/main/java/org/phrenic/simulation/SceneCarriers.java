package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.LesionPlace;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.simulation.observe.OrganCarriers;
import org.phrenic.simulation.observe.OrganMotion;
import org.phrenic.simulation.observe.SkinMotion;

/**
 * What carries the organs of a scene: the central tendon and the liver carry organs of the abdomen, which slide along
 * the muscle of the diaphragm and along the spine. What lies in the liver is carried by that alone, organs of the chest
 * by lungs and central tendon, vessels of the abdominal wall by the skin.
 */
final class SceneCarriers {
    /** Vessels that are fixed to the spine. */
    private static final Pattern FIXED = Pattern.compile("inferior_vena_cava");

    private static final Pattern IN_WALL = Pattern.compile("superior_epigastric_vessels_[rl]");
    /** Points taken of each vertebra and disc, at most. */
    private static final int VERTEBRA_SAMPLE = 40;

    private final Scene scene;
    private final RibCagePose pose;
    private final Optional<LiverPart> liverPart;
    private final OrganCarriers around = new OrganCarriers(120);
    private final OrganCarriers liver = new OrganCarriers(24);
    private final OrganCarriers wall = new OrganCarriers(24);
    private final OrganCarriers chest = new OrganCarriers(24);
    private final int ofSheet;
    private final int ofLiver;
    private final double[] sheet;
    private double[] liverNow = new double[0];
    private final List<SkinMotion> skins = new ArrayList<>();
    private boolean inUse;

    /**
     * @param pose of the rib cage at the time of each update
     * @param liverPart the scene's liver
     */
    SceneCarriers(Scene scene, RibCagePose pose, Optional<LiverPart> liverPart) {
        this.scene = scene;
        this.pose = pose;
        this.liverPart = liverPart;
        DiaphragmPart part = scene.diaphragm();
        sheet = new double[3 * part.diaphragm.sheet().vertexCount()];
        readSheet(scene.restPositions());
        ofSheet = around.addMoving(sheet, part.diaphragm::isTendon);
        chest.addMoving(sheet, part.diaphragm::isTendon);
        if (liverPart.isPresent()) {
            liverNow = liverPart.get().positions(scene.restPositions(), scene.restPositions());
            ofLiver = around.addMoving(liverNow, v -> true);
            liver.addMoving(liverNow, v -> true);
        } else {
            ofLiver = -1;
        }
        for (Structure s : scene.thorax().structures()) {
            if (s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.DISC) {
                around.addStill(s.mesh().positions(), VERTEBRA_SAMPLE);
            }
        }
    }

    /** Adds a lung, which carries organs of the chest; returns its index in {@link #moveLung}. */
    int addLung(double[] rest) {
        return chest.addMoving(rest, v -> true);
    }

    /** States where a lung is. */
    void moveLung(int lung, double[] now) {
        if (inUse) {
            chest.update(lung, now);
        }
    }

    private void readSheet(double[] nodes) {
        System.arraycopy(nodes, 3 * scene.diaphragm().firstNode, sheet, 0, sheet.length);
    }

    /** Vertices of the liver at the last update. */
    double[] liver() {
        return liverNow;
    }

    /** Binds an organ, by its name in lower case, to what carries it. */
    OrganMotion bind(String name, TriangleMesh mesh, SkinningWeights bones) {
        inUse = true;
        double[] rest = mesh.positions();
        if (ofLiver >= 0 && isInLiver(name)) {
            return new OrganMotion(rest, liver, OrganMotion.Hold.SLIDING);
        }
        if (IN_WALL.matcher(name).matches() && bindSkin(bones)) {
            return new OrganMotion(rest, wall, OrganMotion.Hold.SLIDING);
        }
        if (LesionPlace.isInChest(name) || DiaphragmSide.of(StructureKind.ORGAN, name) == DiaphragmSide.ABOVE) {
            return new OrganMotion(rest, chest, OrganMotion.Hold.SLIDING).keepingVolume(mesh);
        }
        boolean fixed = FIXED.matcher(name).matches();
        return new OrganMotion(rest, around, fixed ? OrganMotion.Hold.FIXED : OrganMotion.Hold.SLIDING);
    }

    /** Whether what has a name in lower case lies in the liver and goes with it. */
    static boolean isInLiver(String name) {
        return OrganNames.isVesselInLiver(name) || LesionPlace.isInLiver(name);
    }

    private boolean bindSkin(SkinningWeights bones) {
        if (skins.isEmpty()) {
            for (Structure s : scene.thorax().structuresOf(StructureKind.SKIN)) {
                skins.add(new SkinMotion(scene, s, bones, pose));
                wall.addMoving(s.mesh().positions(), v -> true);
            }
        }
        return !skins.isEmpty();
    }

    /**
     * Takes the places of the carriers from the nodes of the scene; that of the liver alone while there are no organs.
     */
    void update(double time, double[] nodes) {
        liverPart.ifPresent(part -> liverNow = part.positions(scene.restPositions(), nodes));
        if (!inUse) {
            return;
        }
        readSheet(nodes);
        around.update(ofSheet, sheet);
        chest.update(0, sheet);
        if (ofLiver >= 0) {
            around.update(ofLiver, liverNow);
            liver.update(0, liverNow);
        }
        for (int i = 0; i < skins.size(); i++) {
            wall.update(i, skins.get(i).at(time, nodes));
        }
    }
}
