package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * One structure of a patient's body and where it came from.
 *
 * @param structure name and surface, LPS, mm
 * @param source where it came from
 * @param scan what the scan said of it; empty for one that the scan does not have
 * @param distanceToScan for a structure that the scan has too: how far the fitted virtual one lies from it, from the
 *     scan's vertices, by area, mm; empty without a fit
 */
public record PatientStructure(
        Structure structure, Source source, Optional<Scan> scan, Optional<DistanceSummary> distanceToScan) {
    /** Where a structure came from. */
    public enum Source {
        /** Its surface is that of its voxels in the scan. */
        SCAN,
        /** The scan lacks it: the virtual thorax's, brought to the structures that the scan has. */
        VIRTUAL
    }

    /**
     * What the scan says of a structure.
     *
     * @param labels labels it was made of
     * @param voxels how many
     * @param volumeMl of these voxels, ml
     * @param cutAt letters of the sides (L R P A S I) at which the scan ends before the structure does; empty if it is
     *     whole
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

    public static PatientStructure ofScan(Structure structure, Scan scan) {
        return new PatientStructure(structure, Source.SCAN, Optional.of(scan), Optional.empty());
    }

    static PatientStructure ofVirtual(Structure structure) {
        return new PatientStructure(structure, Source.VIRTUAL, Optional.empty(), Optional.empty());
    }

    public PatientStructure withDistanceToScan(DistanceSummary distances) {
        return new PatientStructure(structure, source, scan, Optional.of(distances));
    }
}
