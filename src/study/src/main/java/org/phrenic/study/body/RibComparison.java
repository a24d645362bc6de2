package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibEnds;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.study.ReportNumbers;

/**
 * How far the ribs of an imported body are from those of the body that was scanned, over the ribs of the same name.
 *
 * @param ribs number of ribs compared
 * @param headMeanMm mean distance of the heads
 * @param headGreatestMm greatest distance of the heads
 * @param axisMeanMm mean distance of the helical axes at the original heads
 * @param axisGreatestMm greatest distance of the helical axes at the original heads
 * @param neckMeanDeg mean angle between the necks: the directions from the head to the rib at {@link #NECK_MM}
 * @param neckGreatestDeg greatest angle between the necks
 */
public record RibComparison(
        int ribs,
        double headMeanMm,
        double headGreatestMm,
        double axisMeanMm,
        double axisGreatestMm,
        double neckMeanDeg,
        double neckGreatestDeg) {
    /** Distance from the head at which the direction of the neck is taken, about that of the tubercle, mm. */
    public static final double NECK_MM = 25;

    private static final double NECK_BAND_MM = 5;

    private record Pair(double headMm, double axisMm, double neckDeg) {}

    /** Compares two bodies; empty if no rib of the original has a counterpart. */
    public static Optional<RibComparison> of(Thorax original, Thorax imported) {
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        List<Pair> pairs = new ArrayList<>();
        for (Structure rib : original.structuresOf(StructureKind.RIB)) {
            imported.find(rib.name()).ifPresent(found -> pairs.add(pair(rib, found, table)));
        }
        if (pairs.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(new RibComparison(
                pairs.size(),
                mean(pairs, Pair::headMm),
                greatest(pairs, Pair::headMm),
                mean(pairs, Pair::axisMm),
                greatest(pairs, Pair::axisMm),
                mean(pairs, Pair::neckDeg),
                greatest(pairs, Pair::neckDeg)));
    }

    private static Pair pair(Structure rib, Structure found, RibAxisTable table) {
        double[] head = RibEnds.find(rib.mesh(), rib.side()).head();
        double[] other = RibEnds.find(found.mesh(), found.side()).head();
        HelicalAxis axis = table.axis(found.level(), found.side(), other);
        double[] on = Vectors.of(axis.pointX(), axis.pointY(), axis.pointZ());
        double[] along = Vectors.of(axis.directionX(), axis.directionY(), axis.directionZ());
        return new Pair(
                Vectors.distance(head, other),
                Vectors.distanceToLine(head, on, along),
                Vectors.angleDeg(neck(rib.mesh(), head), neck(found.mesh(), other)));
    }

    /** From the head to the mean of the vertices about {@link #NECK_MM} away from it. */
    private static double[] neck(TriangleMesh rib, double[] head) {
        double[] mean = new double[3];
        int count = 0;
        for (int v = 0; v < rib.vertexCount(); v++) {
            double[] p = {rib.x(v), rib.y(v), rib.z(v)};
            if (Math.abs(Vectors.distance(p, head) - NECK_MM) < NECK_BAND_MM) {
                mean = Vectors.addScaled(mean, p, 1);
                count++;
            }
        }
        return Vectors.addScaled(mean, head, -count);
    }

    private static double mean(List<Pair> pairs, ToDoubleFunction<Pair> measure) {
        return pairs.stream().mapToDouble(measure).average().orElseThrow();
    }

    private static double greatest(List<Pair> pairs, ToDoubleFunction<Pair> measure) {
        return pairs.stream().mapToDouble(measure).max().orElseThrow();
    }

    /** The values as cells of a table, in the order of the components. */
    List<String> cells() {
        List<String> cells = new ArrayList<>(List.of(String.valueOf(ribs)));
        for (double value :
                new double[] {headMeanMm, headGreatestMm, axisMeanMm, axisGreatestMm, neckMeanDeg, neckGreatestDeg}) {
            cells.add(ReportNumbers.number(value));
        }
        return cells;
    }
}
