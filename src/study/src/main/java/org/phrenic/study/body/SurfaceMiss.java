package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.study.ReportNumbers;

/**
 * How far the surfaces of an imported body are from those of the body that was scanned, over the structures of one kind
 * that have the same name in both; distances both ways, by area.
 *
 * @param kind of the structures
 * @param structures number of structures compared
 * @param meanMm mean over the structures of their mean distances
 * @param percentile95Mm greatest of their 95 % quantiles
 */
public record SurfaceMiss(StructureKind kind, int structures, double meanMm, double percentile95Mm) {
    /** The kinds compared: what breathes. */
    private static final List<StructureKind> KINDS = List.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.LUNG,
            StructureKind.LIVER,
            StructureKind.DIAPHRAGM);

    /** Compares two bodies: one entry for each kind of which a structure has a counterpart. */
    public static List<SurfaceMiss> of(Thorax original, Thorax imported) {
        List<SurfaceMiss> misses = new ArrayList<>();
        for (StructureKind kind : KINDS) {
            List<DistanceSummary> distances = new ArrayList<>();
            for (Structure truth : original.structuresOf(kind)) {
                imported.find(truth.name())
                        .ifPresent(found -> distances.add(SurfaceComparison.summaryByArea(truth.mesh(), found.mesh())));
            }
            if (!distances.isEmpty()) {
                misses.add(new SurfaceMiss(
                        kind,
                        distances.size(),
                        distances.stream()
                                .mapToDouble(DistanceSummary::mean)
                                .average()
                                .orElseThrow(),
                        distances.stream()
                                .mapToDouble(DistanceSummary::percentile95)
                                .max()
                                .orElseThrow()));
            }
        }
        return misses;
    }

    /** Cells of a table: kind, number, mean, 95 %. */
    List<String> cells() {
        return List.of(
                ReportNumbers.label(kind).replace('_', ' '),
                String.valueOf(structures),
                ReportNumbers.number(meanMm),
                ReportNumbers.number(percentile95Mm));
    }
}
