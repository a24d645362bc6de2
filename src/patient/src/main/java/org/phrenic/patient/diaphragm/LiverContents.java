package org.phrenic.patient.diaphragm;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/** Vessels, lesions and unknown structures that lie in the liver and go where it goes. */
final class LiverContents {
    /** Least share of the vertices of a structure that lie within the surface of the liver. */
    private static final double LEAST_WITHIN = 0.5;
    /** Number of vertices, about, that tell this share. */
    private static final int SAMPLE = 300;

    private final Set<String> names = new HashSet<>();

    /**
     * Finds what lies in the liver.
     *
     * @param liver the liver; without one, vessels that branch in it are told by their names
     */
    LiverContents(List<Structure> structures, Optional<Structure> liver) {
        Optional<TriangleTree> surface = liver.map(s -> new TriangleTree(s.mesh()));
        for (Structure s : structures) {
            boolean vessel = s.kind() == StructureKind.VESSEL;
            boolean named = vessel && OrganNames.isVesselInLiver(s.name().toLowerCase(Locale.ROOT));
            boolean maybe = vessel || s.kind() == StructureKind.LESION || s.kind() == StructureKind.OTHER;
            if (named
                    || (maybe
                            && surface.filter(tree -> isWithin(s.mesh(), tree)).isPresent())) {
                names.add(s.name());
            }
        }
    }

    boolean has(Structure s) {
        return names.contains(s.name());
    }

    private static boolean isWithin(TriangleMesh mesh, TriangleTree surface) {
        return isShare(mesh, LEAST_WITHIN, v -> surface.isInside(mesh.x(v), mesh.y(v), mesh.z(v)));
    }

    /** Whether at least a share of the vertices satisfies a condition, told by a sample of them. */
    static boolean isShare(TriangleMesh mesh, double least, IntPredicate condition) {
        int step = Math.max(1, mesh.vertexCount() / SAMPLE);
        int[] sample =
                IntStream.iterate(0, v -> v < mesh.vertexCount(), v -> v + step).toArray();
        return IntStream.of(sample).filter(condition).count() >= least * sample.length;
    }
}
