package org.phrenic.access.attempt;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.path.Crossing;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathAnalyzer;
import org.phrenic.anatomy.StructureKind;

/** What lies ahead of the tip of a needle: the bone that stops it, and what a core needle throws its core into. */
final class WayAhead {
    private static final double TOLERANCE_MM = 1e-9;

    private final MovingAnatomy anatomy;
    private final PathAnalyzer analyzer;
    private final Needle needle;
    private final NeedleShaft shaft;

    WayAhead(MovingAnatomy anatomy, PathAnalyzer analyzer, Needle needle, NeedleShaft shaft) {
        this.anatomy = anatomy;
        this.analyzer = analyzer;
        this.needle = needle;
        this.shaft = shaft;
    }

    /** The first bone between the tip and a depth, if any. It may have moved over the tip with the breath. */
    Optional<Crossing> boneBefore(double depth) {
        double[] from = shaft.tip();
        double[] to = shaft.at(depth);
        return anatomy.hazards().stream()
                .filter(s -> s.noGo().orElseThrow() == NoGoZone.BONE && s.boxDistance(from, to) <= 0)
                .flatMap(s -> analyzer.crossingsOf(s, shaft.entry(), to).stream())
                .filter(c -> c.toMm() > shaft.depth() + TOLERANCE_MM)
                .min(Comparator.comparingDouble(Crossing::fromMm));
    }

    /** The bone that ends the throw of a core of a core needle, if any. */
    Optional<Crossing> boneInThrow() {
        return boneBefore(shaft.depth() + needle.coreMm());
    }

    /** Length of the core that a core needle cuts when it fires, which bone ends, mm; empty for another needle. */
    OptionalDouble coreMm() {
        if (needle.coreMm() == 0) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(boneInThrow()
                .map(bone -> Math.max(0, bone.fromMm() - shaft.depth()))
                .orElse(needle.coreMm()));
    }

    /** The structures other than bone on a path to the end of a core that the tip is not in and the core enters. */
    List<Crossing> enteredByCore(PathAnalysis toEnd) {
        double depth = shaft.depth();
        return toEnd.crossings().stream()
                .filter(c -> !NoGoZone.of(c.kind()).equals(Optional.of(NoGoZone.BONE)))
                .filter(c -> c.fromMm() >= depth - TOLERANCE_MM
                        || (c.kind() == StructureKind.LIVER && c.toMm() > depth && !shaft.isTipAnchored()))
                .toList();
    }
}
