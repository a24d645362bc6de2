package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;

/**
 * How far the lungs of a body lie from those of another, both ways and weighted by area: the whole surface, and base
 * from base ({@link DiaphragmaticSurface}), so that a base that has not come down is not measured from the costal
 * surface beside it.
 *
 * @param whole of the whole surfaces, mm
 * @param base of the bases, mm
 */
public record LungDistances(DistanceSummary whole, DistanceSummary base) {

    /** Distances of one lung. */
    public static LungDistances of(TriangleMesh a, TriangleMesh b) {
        return of(List.of(a), List.of(b));
    }

    /**
     * Distances of lungs, each from the one of the same place in the other list, taken together.
     *
     * @throws IllegalArgumentException if a lung has no base
     */
    public static LungDistances of(List<TriangleMesh> a, List<TriangleMesh> b) {
        List<SurfaceComparison> whole = new ArrayList<>();
        List<SurfaceComparison> base = new ArrayList<>();
        for (int i = 0; i < a.size(); i++) {
            whole.add(SurfaceComparison.of(a.get(i), b.get(i)));
            base.add(SurfaceComparison.of(DiaphragmaticSurface.of(a.get(i)), DiaphragmaticSurface.of(b.get(i))));
        }
        return new LungDistances(pooled(whole), pooled(base));
    }

    private static DistanceSummary pooled(List<SurfaceComparison> comparisons) {
        List<double[]> distances = new ArrayList<>();
        List<double[]> weights = new ArrayList<>();
        for (SurfaceComparison c : comparisons) {
            distances.add(c.aToB().distances());
            distances.add(c.bToA().distances());
            weights.add(c.aToB().weights());
            weights.add(c.bToA().weights());
        }
        return DistanceSummary.of(flat(distances), flat(weights));
    }

    private static double[] flat(List<double[]> parts) {
        return parts.stream().flatMapToDouble(java.util.Arrays::stream).toArray();
    }

    /** The lung of a side, its lobes in one surface; empty if a body has none. */
    public static Optional<TriangleMesh> lung(Thorax thorax, Side side) {
        List<TriangleMesh> lobes = thorax.structuresOf(StructureKind.LUNG).stream()
                .filter(s -> s.side() == side)
                .map(Structure::mesh)
                .toList();
        return lobes.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(lobes));
    }

    /** Distances of each lung that both bodies have, and of {@code both} together, in the order right, left, both. */
    public static Map<String, LungDistances> between(Thorax a, Thorax b) {
        Map<String, LungDistances> all = new LinkedHashMap<>();
        List<TriangleMesh> ofA = new ArrayList<>();
        List<TriangleMesh> ofB = new ArrayList<>();
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            Optional<TriangleMesh> first = lung(a, side);
            Optional<TriangleMesh> second = lung(b, side);
            if (first.isPresent() && second.isPresent()) {
                ofA.add(first.get());
                ofB.add(second.get());
                all.put(side == Side.RIGHT ? "right" : "left", of(first.get(), second.get()));
            }
        }
        if (ofA.size() == 2) {
            all.put("both", of(ofA, ofB));
        }
        return all;
    }
}
