package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.voxel.CutPlane;

/**
 * A structure of a patient's body and its source.
 *
 * @param structure name and surface, LPS, mm
 * @param scan properties of the structure in the scan; empty if it is not in the scan
 * @param distanceToScan area-weighted distances from the vertices of the scan to the registered template, mm; empty if
 *     no template was registered
 */
public record PatientStructure(
        Structure structure, Source source, Optional<Scan> scan, Optional<DistanceSummary> distanceToScan) {
    /** Source of a structure. */
    public enum Source {
        /** The voxel surface of the scan, or a mesh of the imported folder. */
        SCAN,
        /** The surface of the scan with a part of a registered template that the scan lacks. */
        EXTENDED,
        /** A registered template, used where the structure is missing from the scan or truncated. */
        VIRTUAL,
        /** Built from the organs and bones of the body that it touches. */
        BUILT
    }

    /**
     * Properties of a structure in the scan.
     *
     * @param cuts ends of the scan at which it truncates the structure; empty if it is complete
     * @param meshed surface mesh with its statistics, where the scan shows it
     */
    public record Scan(List<Integer> labels, int voxels, double volumeMl, List<CutPlane> cuts, MeshedSegment meshed) {
        public Scan {
            labels = List.copyOf(labels);
            cuts = List.copyOf(cuts);
        }

        /** Returns a copy with other ends at which the scan truncates the structure. */
        public Scan withCuts(List<CutPlane> ends) {
            return new Scan(labels, voxels, volumeMl, ends, meshed);
        }

        /** Returns a copy with another surface where the scan shows it. */
        public Scan withShown(TriangleMesh mesh) {
            return new Scan(labels, voxels, volumeMl, cuts, meshed.withMesh(mesh));
        }

        /** Letters of the sides (L R P A S I) at which the scan truncates the structure; empty if it is complete. */
        public String cutAt() {
            return cuts.stream().map(CutPlane::side).collect(Collectors.joining());
        }

        /** Whether the scan contains the complete structure. */
        public boolean isComplete() {
            return cuts.isEmpty();
        }
    }

    /** Creates a structure from a scan. */
    public static PatientStructure ofScan(Structure structure, Scan scan) {
        return new PatientStructure(structure, Source.SCAN, Optional.of(scan), Optional.empty());
    }

    /** Whether the structure is not truncated by a scan. */
    public boolean isComplete() {
        return cuts().isEmpty();
    }

    /** Whether the scan truncates the structure at its upper or lower end at most. */
    public boolean isCutAlongBody() {
        return cuts().stream().allMatch(cut -> "SI".contains(cut.side()));
    }

    /** Ends of the scan at which it truncates the structure. */
    public List<CutPlane> cuts() {
        return scan.map(Scan::cuts).orElse(List.of());
    }

    /** The surface where the scan shows it, wherever its vertices have been moved since. */
    public TriangleMesh shown() {
        return scan.map(s -> s.meshed().mesh())
                .filter(mesh -> mesh.vertexCount() == structure.mesh().vertexCount())
                .orElse(structure.mesh());
    }

    /**
     * Marks the vertices on the faces at which the scan truncates the structure, wherever these have been moved since.
     *
     * @param distanceMm distance from the end of the scan within which a vertex belongs to such a face, mm
     */
    public boolean[] verticesAtCut(double distanceMm) {
        double[] p = shown().positions();
        boolean[] at = new boolean[p.length / 3];
        List<CutPlane> cuts = cuts();
        for (int v = 0; v < at.length && !cuts.isEmpty(); v++) {
            int first = 3 * v;
            at[v] = cuts.stream().anyMatch(cut -> cut.isReachedBy(p, first, distanceMm));
        }
        return at;
    }

    /** Returns a copy with another surface. */
    public PatientStructure withStructure(Structure other) {
        return new PatientStructure(other, source, scan, distanceToScan);
    }

    /** Returns a copy whose surface comes from the scan and a template. */
    public PatientStructure extended(TriangleMesh whole) {
        return new PatientStructure(structure.withMesh(whole), Source.EXTENDED, scan, distanceToScan);
    }

    /** Returns a copy with the distances to the registered template. */
    public PatientStructure withDistanceToScan(DistanceSummary distances) {
        return new PatientStructure(structure, source, scan, Optional.of(distances));
    }
}
