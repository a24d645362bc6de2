package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.patient.LungOutline;

/**
 * Area-weighted symmetric distances between the lungs of two bodies, mm. They are given for the whole surfaces and for
 * the bases ({@link DiaphragmaticSurface}) only. Bases are compared with bases, so that a base is not matched to the
 * adjacent costal surface.
 */
public record LungDistances(DistanceSummary whole, DistanceSummary base) {
    /**
     * Pooled distances between lungs with the same index.
     *
     * @throws IllegalArgumentException if a lung has no base
     */
    public static LungDistances of(List<TriangleMesh> a, List<TriangleMesh> b) {
        return new LungDistances(
                pooled(a, b),
                pooled(
                        a.stream().map(DiaphragmaticSurface::of).toList(),
                        b.stream().map(DiaphragmaticSurface::of).toList()));
    }

    private static DistanceSummary pooled(List<TriangleMesh> a, List<TriangleMesh> b) {
        List<double[]> distances = new ArrayList<>();
        List<double[]> weights = new ArrayList<>();
        for (int i = 0; i < a.size(); i++) {
            SurfaceComparison c = SurfaceComparison.of(a.get(i), b.get(i));
            Stream.of(c.aToB(), c.bToA()).forEach(side -> {
                distances.add(side.distances());
                weights.add(side.weights());
            });
        }
        return DistanceSummary.of(flat(distances), flat(weights));
    }

    private static double[] flat(List<double[]> parts) {
        return parts.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /** The outline of the lung of one side ({@link LungOutline}), or empty if the body has none. */
    public static Optional<TriangleMesh> lung(Thorax thorax, Side side) {
        return LungOutline.of(thorax.structuresOf(StructureKind.LUNG).stream().filter(s -> s.side() == side));
    }

    /** Distances for each lung that both bodies have, and pooled under {@code both}. The order is right, left, both. */
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
                all.put(side == Side.RIGHT ? "right" : "left", of(List.of(first.get()), List.of(second.get())));
            }
        }
        if (ofA.size() == 2) {
            all.put("both", of(ofA, ofB));
        }
        return all;
    }
}
