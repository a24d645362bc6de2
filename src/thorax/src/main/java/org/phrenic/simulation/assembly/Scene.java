package org.phrenic.simulation.assembly;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.simulation.organ.DiaphragmPart;
import org.phrenic.simulation.organ.LiverPart;
import org.phrenic.simulation.organ.LungPart;
import org.phrenic.simulation.organ.SternumPart;

/**
 * A thorax put together for a run: the nodes and what pulls on them, and which nodes belong to which organ.
 *
 * @param thorax as it was loaded or generated
 * @param system the nodes
 * @param restPositions positions of all nodes at end-expiration, caller's order, mm; written once, when the scene has
 *     settled
 * @param pose of the rib cage
 * @param drive from the breathing pattern
 * @param diaphragm always there
 * @param sternum where it is a mass-spring system
 * @param lungs where they are a mass-spring system
 * @param embeddedLungs where they are carried instead
 * @param liver where the scene has one
 * @param forces what pulls on the nodes
 * @param springCount how many
 * @param heldNodes nodes that bone holds, directly or by springs
 * @param prestressResidual share of the load at rest that the sheet's tensions do not carry
 * @param massAddedPercent what {@link MassScaling} added to the mass of all nodes, per cent
 */
public record Scene(
        Thorax thorax,
        ParticleSystem system,
        double[] restPositions,
        RibCagePose pose,
        BreathDrive drive,
        DiaphragmPart diaphragm,
        Optional<SternumPart> sternum,
        Optional<LungPart> lungs,
        List<Structure> embeddedLungs,
        Optional<LiverPart> liver,
        SceneForces forces,
        int springCount,
        int[] heldNodes,
        double prestressResidual,
        double massAddedPercent) {

    /** The tendon's rigid links, while they are switched on. */
    public Optional<RigidLinks> activeLinks() {
        return forces.links().filter(system::isEnabled);
    }

    /** How many nodes bone holds. */
    public int attachmentCount() {
        return heldNodes.length;
    }
}
