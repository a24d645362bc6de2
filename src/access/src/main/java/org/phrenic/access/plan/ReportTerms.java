package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.AbsentObstacles;
import org.phrenic.access.CostalGroove;
import org.phrenic.access.Needle;
import org.phrenic.access.PleuralReflection;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.observe.Surface;

/** What the words of a report mean. */
final class ReportTerms {
    private ReportTerms() {}

    /** Definitions of the terms in the report, and the limitations of this body. */
    static List<String> of(Rehearsal rehearsal) {
        List<String> words = new ArrayList<>(List.of(
                hit(rehearsal.plan().needle()),
                "Pleural recess: the space between the inner rib cage and the diaphragm where no lung lies; crossed by"
                        + " a path through the pleura, or, on a side without a surface of it, one that enters the"
                        + " diaphragm more than " + mm(PleuralReflection.HEIGHT_ABOVE_ORIGIN_MM)
                        + " mm above its lower rim.",
                "Vessels below a rib: within " + mm(CostalGroove.NEUROVASCULAR_ZONE_MM)
                        + " mm of the rib's lower border.",
                "Capsule pulled: distance between the needle and where it went through the capsule, which moves with"
                        + " the liver.",
                "Forces: readouts of a model of layers, most of whose values are chosen; they move nothing.",
                "The body has no organs but those listed in its scene: bowel, gall bladder, kidney and large vessels"
                        + " count only where the body has them.",
                AttemptRecord.NOT_VALIDATED));
        AbsentObstacles.sentence(
                        rehearsal.surfaces().stream().map(Surface::name).toList())
                .ifPresent(absent -> words.add(Character.toUpperCase(absent.charAt(0)) + absent.substring(1) + "."));
        return words;
    }

    private static String hit(Needle needle) {
        return (needle.coreMm() > 0
                        ? "Hit: a part of the core was within the target when a sample was taken. Axial: from the"
                                + " middle of the core along the needle"
                        : "Hit: the tip was in the liver and within the target when a sample was taken. Axial: along"
                                + " the needle")
                + ", positive where the target's middle lies deeper; lateral: distance of the middle from the needle's"
                + " line.";
    }

    private static String mm(double value) {
        return Numbers.format("%.1f", value);
    }
}
