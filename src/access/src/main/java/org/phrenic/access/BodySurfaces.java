package org.phrenic.access;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Thorax;
import org.phrenic.simulation.observe.Surface;

/**
 * The surfaces of a body, and what of it does not come from its scan.
 *
 * @param surfaces in the order of the frames
 * @param notInScan names of structures and words for what else the scan does not show; empty unless it is a scanned
 *     body
 * @param notInScanSummary the same by kinds, such as "skin, 4 of 24 ribs"; empty for none
 */
public record BodySurfaces(List<Surface> surfaces, Set<String> notInScan, String notInScanSummary) {
    /** A body that is no scan, or wholly in its scan. */
    public BodySurfaces(List<Surface> surfaces) {
        this(surfaces, Set.of(), "");
    }

    /** @param surfaces of a scene of the body */
    public BodySurfaces(List<Surface> surfaces, Thorax body) {
        this(surfaces, body.notInScan(), body.notInScanSummary());
    }

    /** What of a structure the scan does not show: its label, words for a part of it, or empty. */
    public Optional<String> notInScanOf(Surface structure) {
        if (notInScan.contains(structure.name())) {
            return Optional.of(MovingStructure.label(structure));
        }
        return Optional.of(Thorax.partOf(structure.kind(), structure.name())).filter(notInScan::contains);
    }
}
