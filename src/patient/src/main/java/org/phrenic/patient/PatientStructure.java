package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * One structure of a patient's body, and its source.
 *
 * @param structure name and surface, LPS, mm
 * @param scan its properties in the scan; empty if the scan lacks it
 * @param distanceToScan distances of the scan's vertices from the registered template, by area, mm; empty without one
 */
public record PatientStructure(
        Structure structure, Source source, Optional<Scan> scan, Optional<DistanceSummary> distanceToScan) {
    /** Sources of structures. */
    public enum Source {
        /** The surface of its voxels in the scan. */
        SCAN,
        /** A registered template: the scan lacks it or cuts it off. */
        VIRTUAL
    }

    /**
     * Properties of a structure in the scan.
     *
     * @param cutAt letters of the sides (L R P A S I) at which the scan cuts it; empty if it is complete
     * @param meshed how its surface was made
     */
    public record Scan(List<Integer> labels, int voxels, double volumeMl, String cutAt, MeshedSegment meshed) {
        public Scan {
            labels = List.copyOf(labels);
        }

        /** Whether the scan holds all of it. */
        public boolean isComplete() {
            return cutAt.isEmpty();
        }
    }

    /** A structure of a scan. */
    public static PatientStructure ofScan(Structure structure, Scan scan) {
        return new PatientStructure(structure, Source.SCAN, Optional.of(scan), Optional.empty());
    }

    /** Whether no scan cuts it off. */
    public boolean isComplete() {
        return scan.map(Scan::isComplete).orElse(true);
    }

    /** The structure with another surface. */
    public PatientStructure withStructure(Structure other) {
        return new PatientStructure(other, source, scan, distanceToScan);
    }

    /** The structure with distances from the registered template. */
    public PatientStructure withDistanceToScan(DistanceSummary distances) {
        return new PatientStructure(structure, source, scan, Optional.of(distances));
    }
}
