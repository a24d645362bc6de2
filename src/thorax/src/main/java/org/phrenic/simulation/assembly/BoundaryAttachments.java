package org.phrenic.simulation.assembly;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.FallOff;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.organ.DiaphragmPart;
import org.phrenic.simulation.organ.MassSpringBuilder;

/**
 * What holds the nodes of a scene in the body: the insertion of the diaphragm follows bone exactly, the origin of the
 * crura, sternum, cartilages and lungs by springs to anchors on bone.
 */
final class BoundaryAttachments {
    /** Fall-off of the paper's attachments round the insertion, and their low elasticity as a share of a spring's. */
    private static final double ATTACHMENT_MM = 25;

    private static final double ATTACHMENT_SHARE = 0.1;
    private static final double HOME_SHARE = 0.25;

    /** Springs to bone. */
    final Optional<Attachments> bone;
    /** The paper's springs that bring the sheet back. */
    final Optional<Attachments> restoringSprings;
    /** All nodes that bone holds, exactly or by springs. */
    final int[] heldNodes;

    /** Holds the nodes of a scene; anchors are taken anew every {@code refresh} s. */
    BoundaryAttachments(
            Scenario scenario,
            Thorax thorax,
            MassSpringBuilder parts,
            ParticleSystem system,
            DiaphragmPart diaphragm,
            SkinningWeights bones,
            RibCagePose pose,
            double[] positions,
            double refresh) {
        Workers workers = system.workers();
        int[] inserted = diaphragm.insertedVertices();
        if (inserted.length == 0) {
            throw new BadInputException(thorax.name() + ": the diaphragm has no border that bone could hold, expected a"
                    + " sheet whose two faces meet at its insertion");
        }
        double[] rim = MassSpringBuilder.positionsOf(positions, diaphragm.firstNode, inserted);
        system.prescribe(
                MassSpringBuilder.offset(inserted, diaphragm.firstNode),
                new LinearBlendSkinning(pose, rim, bones.weightsAt(rim), workers));
        if (scenario.material() == TissueMaterial.PAPER) {
            Diaphragm sheet = diaphragm.diaphragm;
            for (int i = 0; i < sheet.sheet().vertexCount(); i++) {
                double fade = FallOff.at(sheet.distanceFromInsertion(i), ATTACHMENT_MM);
                if (fade > 0 && !sheet.isInserted(i)) {
                    parts.attachToBone(
                            diaphragm.firstNode + i,
                            ATTACHMENT_SHARE * scenario.value(Parameter.SPRING_STIFFNESS) * fade);
                }
            }
        }
        int[] crural = diaphragm.cruralNodes;
        if (crural.length > 0) {
            // The spine stands still.
            PrescribedMotion onVertebrae =
                    PrescribedMotion.stationary(MassSpringBuilder.positionsOf(positions, 0, crural));
            system.add(new Attachments(system.layout(), crural, diaphragm.cruralStiffnesses, 0, onVertebrae));
        }
        Optional<Attachments> toBone = Optional.empty();
        Optional<Attachments> toPlace = Optional.empty();
        int[] listed = parts.attachedNodes();
        // In the order of memory, so that anchors need not be sorted at every refresh.
        int[] order = system.layout().inMemoryOrder(listed);
        int[] attached = Arrays.stream(order).map(i -> listed[i]).toArray();
        if (attached.length > 0) {
            double[] stiffness = parts.attachedStiffnesses();
            double[] anchors = MassSpringBuilder.positionsOf(positions, 0, attached);
            Attachments springs = new Attachments(
                    system.layout(),
                    attached,
                    Arrays.stream(order).mapToDouble(i -> stiffness[i]).toArray(),
                    0,
                    new LinearBlendSkinning(pose, anchors, bones.weightsAt(anchors), workers));
            springs.setRefreshInterval(refresh);
            springs.setStiffnessFactor(scenario.value(Parameter.STERNUM_COUPLING));
            system.add(springs);
            toBone = Optional.of(springs);
        }
        if (scenario.material() == TissueMaterial.PAPER) {
            toPlace = Optional.of(restoringSprings(scenario, system, diaphragm, positions));
            system.add(toPlace.get());
        }
        bone = toBone;
        restoringSprings = toPlace;
        heldNodes = MassSpringBuilder.concatenate(MassSpringBuilder.offset(inserted, diaphragm.firstNode), attached);
    }

    /**
     * The paper's sheet has no pressure below it and no bending: nothing would bring it back after a breath. Every node
     * is held to its place by a spring of low elasticity, soft enough that the action lines move the dome, quick enough
     * (6 1/s) to follow a breath.
     */
    private static Attachments restoringSprings(
            Scenario scenario, ParticleSystem system, DiaphragmPart diaphragm, double[] positions) {
        int[] free = MassSpringBuilder.offset(diaphragm.freeVertices(), diaphragm.firstNode);
        double[] stiffness = new double[free.length];
        Arrays.fill(stiffness, HOME_SHARE * scenario.value(Parameter.SPRING_STIFFNESS));
        return new Attachments(
                system.layout(),
                free,
                stiffness,
                0,
                PrescribedMotion.stationary(MassSpringBuilder.positionsOf(positions, 0, free)));
    }
}
