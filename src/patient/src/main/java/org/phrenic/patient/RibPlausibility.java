package org.phrenic.patient;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.query.TriangleTree;

/** Checks whether the ribs of a scan without cartilages end as far from the sternum as bone does. */
final class RibPlausibility {
    /** Ribs that are looked at: cartilages of the next ones join those of others before they reach the sternum. */
    private static final int FIRST = 2;

    private static final int LAST = 5;
    /** Distance from the sternum within which a rib reaches it, mm; bone of four bodies ends 18 to 79 mm from it. */
    private static final double REACH_MM = 15;

    private RibPlausibility() {}

    /** Returns a note if the ribs of a side reach the sternum in a scan without cartilages. */
    static Optional<String> check(List<PatientStructure> structures) {
        List<Structure> scanned =
                structures.stream().map(PatientStructure::structure).toList();
        Optional<TriangleTree> sternum = PatientBody.merged(
                        scanned.stream().filter(s -> s.kind() == StructureKind.STERNUM))
                .map(TriangleTree::new);
        if (sternum.isEmpty() || scanned.stream().anyMatch(s -> s.kind() == StructureKind.COSTAL_CARTILAGE)) {
            return Optional.empty();
        }
        List<String> sides = Stream.of(Side.RIGHT, Side.LEFT)
                .filter(side -> reaching(scanned, side, sternum.get()) == LAST - FIRST + 1)
                .map(side -> side.name().toLowerCase(Locale.ROOT))
                .toList();
        return sides.isEmpty()
                ? Optional.empty()
                : Optional.of("no cartilages are labelled, and ribs " + FIRST + " to " + LAST + " on the "
                        + String.join(" and the ", sides) + " reach the sternum: the labels of these bones seem to hold"
                        + " the cartilages, which are bone then");
    }

    private static long reaching(List<Structure> scanned, Side side, TriangleTree sternum) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        return scanned.stream()
                .filter(s -> s.kind() == StructureKind.RIB && s.side() == side)
                .filter(s -> s.level() >= FIRST && s.level() <= LAST)
                .map(Structure::mesh)
                .filter(rib -> IntStream.range(0, rib.vertexCount())
                        .anyMatch(v -> sternum.isWithin(rib.x(v), rib.y(v), rib.z(v), REACH_MM, hit)))
                .count();
    }
}
