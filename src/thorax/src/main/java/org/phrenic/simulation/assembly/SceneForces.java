package org.phrenic.simulation.assembly;

import java.util.Optional;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.Springs;

/**
 * What pulls on the nodes of a scene, as far as it can be tuned while it runs. What a scenario has switched off is
 * there as well, switched off.
 *
 * @param sheet springs of the diaphragm
 * @param passive all other springs
 * @param boneAttachments springs to bone
 * @param restoring the paper's springs that bring the sheet back
 * @param lungBase springs from the lungs to the diaphragm; only in the physical material
 * @param restPressure what holds the sheet against the pressure at rest; only in the physical material
 * @param lines the paper's action lines
 * @param links rigid links of the tendon, if there are any
 * @param contact of the sheet with the chest wall; only in the physical material
 */
public record SceneForces(
        Springs sheet,
        Optional<Springs> passive,
        Optional<Attachments> boneAttachments,
        Optional<Attachments> restoring,
        Optional<Attachments> lungBase,
        Optional<RestPressure> restPressure,
        ActionLine[] lines,
        Optional<RigidLinks> links,
        Optional<SlidingContact> contact) {}
