package org.phrenic.model.assembly;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.Springs;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.model.organ.LungPart;
import org.phrenic.model.organ.SternumPart;

/** A thorax put together for a run: the nodes and what pulls on them, and which nodes belong to which organ. */
public final class Scene {
    private final SceneBuilder parts;
    private final Optional<SternumPart> sternum;
    private final Optional<LiverPart> liver;
    private final List<Structure> embeddedLungs;
    private final double massAddedPercent;

    /** @param parts with all parts added */
    public Scene(
            SceneBuilder parts,
            Optional<SternumPart> sternum,
            Optional<LiverPart> liver,
            List<Structure> embeddedLungs,
            double massAddedPercent) {
        this.parts = parts;
        this.sternum = sternum;
        this.liver = liver;
        this.embeddedLungs = embeddedLungs;
        this.massAddedPercent = massAddedPercent;
    }

    /** As it was loaded or generated. */
    public Thorax thorax() {
        return parts.thorax();
    }

    /** The nodes. */
    public ParticleSystem system() {
        return parts.system();
    }

    /** Positions of all nodes at end-expiration, caller's order, mm; written once, when the scene has settled. */
    public double[] restPositions() {
        return parts.positions();
    }

    /** The rib cage. */
    public RibCagePose pose() {
        return parts.pose();
    }

    /** The breathing. */
    public BreathDrive drive() {
        return parts.drive();
    }

    /** What can be changed while it runs. */
    public SceneTuning tuning() {
        return parts.tuning();
    }

    public DiaphragmPart diaphragm() {
        return parts.diaphragm();
    }

    /** Where sternum and cartilages are a mass-spring system. */
    public Optional<SternumPart> sternum() {
        return sternum;
    }

    /** Where the lungs are a mass-spring system. */
    public Optional<LungPart> lungs() {
        return parts.lungs();
    }

    /** Where the lungs are carried instead. */
    public List<Structure> embeddedLungs() {
        return embeddedLungs;
    }

    public Optional<LiverPart> liver() {
        return liver;
    }

    /** Springs of the diaphragm. */
    public Springs sheetSprings() {
        return parts.sheet();
    }

    /** All other springs between nodes. */
    public Optional<Springs> passiveSprings() {
        return Optional.ofNullable(parts.passive());
    }

    /** What holds the base of the lungs to the diaphragm, where they are a mass-spring system. */
    public Optional<Attachments> lungBase() {
        return Optional.ofNullable(parts.lungBase());
    }

    /** The tendon's rigid links, on or off. */
    public Optional<RigidLinks> links() {
        return Optional.ofNullable(parts.links());
    }

    /** The tendon's rigid links, while they are switched on. */
    public Optional<RigidLinks> activeLinks() {
        return links().filter(system()::isEnabled);
    }

    /** Places x, y of vertical action lines, mm. */
    public List<double[]> actionLines() {
        return List.copyOf(parts.actionLines());
    }

    /** How many springs there are between nodes. */
    public int springCount() {
        return parts.springCount();
    }

    /** Nodes that bone holds, exactly or by springs. */
    public int[] heldNodes() {
        return parts.heldNodes();
    }

    /** How many nodes bone holds. */
    public int attachmentCount() {
        return heldNodes().length;
    }

    /** Share of the load at rest that the sheet's tensions do not carry. */
    public double prestressResidual() {
        return parts.restPressure() == null ? 0 : parts.restPressure().residual();
    }

    /** What mass scaling added to the mass of all nodes, per cent. */
    public double massAddedPercent() {
        return massAddedPercent;
    }
}
