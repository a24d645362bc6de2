package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.SpineLevels;

/**
 * The breath level at which a body was scanned, from the height of its lungs against the spine.
 *
 * @param mark what was measured
 * @param right level of that mark on the right in vertebrae: 8.5 is half way from the middle of T8 to that of T9; NaN
 *     if the scan does not show it
 * @param left level on the left
 * @param descent mean descent of the mark from end-expiration, vertebrae
 * @param share that descent as a share of the descent to full inspiration, 0 at end-expiration
 * @param descentMm that descent, mm
 * @param parted side of the lung whose base stands so much higher than the other one's that it does not lie on the
 *     diaphragm, if no organ of the scan shows where that is; its base tells no level
 */
public record BreathLevel(
        Mark mark, double right, double left, double descent, double share, double descentMm, Optional<Side> parted) {
    /** A level read off both sides, or off one because the scan does not show the other. */
    BreathLevel(Mark mark, double right, double left, double descent, double share, double descentMm) {
        this(mark, right, left, descent, share, descentMm, Optional.empty());
    }

    /** What the level is read from. */
    public enum Mark {
        /**
         * Domes of the lungs' bases: T8 and T9 at end-expiration, T11/T12 and T12 at full inspiration (physiology C2).
         */
        DOMES("the domes", "T8 and T9", new double[] {8, 9}, new double[] {11.5, 12}, 0.2),
        /** The same, with the upper surface of the organs below a lung whose base lies far above them. */
        ORGANS("the domes, by the organs below a lung that ends far above them,", DOMES, 0.2),
        /** Top of the liver in a scan that shows no right lung: the right dome lies there. */
        LIVER("the top of the liver", "T8", new double[] {8, 9}, new double[] {11.5, 12}, 0.3),
        /** The same in a scan without bones, against the spine that the costal surfaces of the lungs imply. */
        SHAPE("the domes, by the shape of the lungs alone,", DOMES, 0.3),
        /**
         * Lowest points of the lungs, in a scan that ends below the domes: beside the spine at rib 10 at
         * end-expiration, two ribs lower at full inspiration.
         */
        LOWER_BORDERS("the lower borders of the lungs", "T11", new double[] {11, 11}, new double[] {13, 13}, 0.3);

        private final String name;
        private final String atExpiration;
        private final double[] expired;
        private final double[] inspired;
        /** Share from which a scan counts as one at inspiration: about what people differ by. */
        private final double clearlyInspired;

        Mark(String name, String atExpiration, double[] expired, double[] inspired, double clearlyInspired) {
            this.name = name;
            this.atExpiration = atExpiration;
            this.expired = expired;
            this.inspired = inspired;
            this.clearlyInspired = clearlyInspired;
        }

        /** A mark with the levels of another. */
        Mark(String name, Mark other, double clearlyInspired) {
            this(name, other.atExpiration, other.expired, other.inspired, clearlyInspired);
        }
    }

    /** Least number of vertebrae and ribs in a scan whose level is judged. */
    private static final int LEAST_BONES = 6;
    /** Least height of a scan above the domes that it shows, mm. */
    private static final double ABOVE_DOMES_MM = 5;

    /** Least height of a dome above the lower end of a scan that cuts its lung off there, mm. */
    private static final double SHOWN_DOME_MM = 30;

    /** Level from which on a flat face of a lung that is cut off is no dome: a vertebra below full inspiration. */
    private static final double LOWEST_DOME = 13;

    /** Share up to which domes stand high: below those of the bodies of {@code bench bodies} at rest, -0.21 or more. */
    private static final double HIGH = -0.3;

    /**
     * Least volume of a whole liver, cubes of the mean distance of vertebrae: 750 ml in an adult, half of a usual one.
     */
    private static final double LEAST_LIVER = 55;

    /** Vertebrae by which the left dome stands lower than the right one, in the mean. */
    private static final double LEFT_BELOW_RIGHT = 1;
    /** Least difference from that, vertebrae, which the domes of few people have. */
    private static final double UNEQUAL = 2;

    /** Steps of a stated level in a vertebra. */
    private static final double TENTHS = 10;

    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 2;

    /**
     * Estimates the level of a body; empty if the scan shows neither the dome below a lung nor its lower end nor the
     * top of the liver. A scan that ends below the top of a completed lung's base does not show the domes. Of a scan
     * with few bones and two whole lungs the level is known only if it is clearly one at inspiration.
     *
     * @param scanned body as scanned, LPS, mm
     * @param completed the same body, completed
     */
    public static Optional<BreathLevel> of(PatientBody scanned, PatientBody completed) {
        long bones = completed.structures().stream()
                .filter(s -> s.source() == PatientStructure.Source.SCAN
                        || s.source() == PatientStructure.Source.EXTENDED
                        || s.scan().isPresent())
                .map(s -> s.structure().kind())
                .filter(kind -> kind == StructureKind.VERTEBRA || kind == StructureKind.RIB)
                .count();
        SpineLevels spine = SpineLevels.of(completed.thorax(), LAST_LEVEL);
        if (spine.count() < 2 || (bones < LEAST_BONES && !showsWholeLungs(scanned))) {
            return Optional.empty();
        }
        List<LungBase> right = bases(scanned, completed, Side.RIGHT);
        List<LungBase> left = bases(scanned, completed, Side.LEFT);
        double[] domes = {dome(right, scanned, Side.RIGHT, spine), dome(left, scanned, Side.LEFT, spine)};
        List<LungBase> both = Stream.concat(right.stream(), left.stream()).toList();
        boolean areCut = isCutBelow(scanned, Side.RIGHT) || isCutBelow(scanned, Side.LEFT);
        Optional<Side> parted = areCut ? Optional.empty() : UnequalBases.parted(scanned.thorax(), both);
        parted.ifPresent(side -> domes[side == Side.RIGHT ? 0 : 1] = Double.NaN);
        if (bones < LEAST_BONES) {
            return measured(Mark.SHAPE, domes, spine)
                    .filter(BreathLevel::isInspired)
                    .map(level -> level.with(parted));
        }
        double[] borders = {border(scanned, Side.RIGHT), border(scanned, Side.LEFT)};
        double[] ends = {lowerEnd(scanned, Side.RIGHT), lowerEnd(scanned, Side.LEFT)};
        boolean byOrgans = both.stream().anyMatch(base -> !base.liesOnDiaphragm());
        Mark byLiver = lobes(scanned, Side.RIGHT).isEmpty() ? Mark.LIVER : Mark.DOMES;
        return measured(byOrgans ? Mark.ORGANS : Mark.DOMES, domes, spine)
                .or(() -> measured(Mark.LOWER_BORDERS, borders, spine))
                .or(() -> measured(byLiver, new double[] {topOfLiver(scanned), Double.NaN}, spine)
                        .filter(level -> byLiver == Mark.DOMES || (level.share <= 1 && hasWholeLiver(scanned, spine))))
                .or(() -> measured(Mark.LOWER_BORDERS, ends, spine).filter(BreathLevel::isInspired))
                .map(level -> level.with(parted));
    }

    private BreathLevel with(Optional<Side> partedSide) {
        return new BreathLevel(mark, right, left, descent, share, descentMm, partedSide);
    }

    /** @param heights of the mark on the right and the left, mm; NaN for none */
    private static Optional<BreathLevel> measured(Mark mark, double[] heights, SpineLevels spine) {
        double[] level = {Double.NaN, Double.NaN};
        double descent = 0;
        double share = 0;
        double descentMm = 0;
        int sides = 0;
        for (int i = 0; i < 2; i++) {
            if (!Double.isNaN(heights[i])) {
                level[i] = spine.levelAt(heights[i]);
                descent += level[i] - mark.expired[i];
                share += (level[i] - mark.expired[i]) / (mark.inspired[i] - mark.expired[i]);
                descentMm += spine.heightOf(mark.expired[i]) - heights[i];
                sides++;
            }
        }
        return sides == 0
                ? Optional.empty()
                : Optional.of(
                        new BreathLevel(mark, level[0], level[1], descent / sides, share / sides, descentMm / sides));
    }

    /** Whether the scan is one at inspiration beyond the differences between people. */
    public boolean isInspired() {
        return share >= mark.clearlyInspired;
    }

    /**
     * Whether the domes stand above their usual level at end-expiration beyond the differences between people. Lower
     * borders of lungs do not tell it, as fluid lifts them.
     */
    public boolean standsHigh() {
        return share <= HIGH && mark != Mark.LOWER_BORDERS;
    }

    /** Whether the two domes stand at heights that differ as those of few people do. */
    public boolean isUnequal() {
        return mark != Mark.LOWER_BORDERS && Math.abs(left - right - LEFT_BELOW_RIGHT) >= UNEQUAL;
    }

    /** Whether the scan shows an organ below the diaphragm, so that a lung lifted by fluid is told from a high dome. */
    public static boolean showsOrgansBelow(Thorax body) {
        return ContactingOrgans.abdominal(body).stream().anyMatch(body::isInScan);
    }

    /**
     * The levels of the mark, such as "the domes at T9.4 on the right and T10.7 on the left (T8 and T9 at
     * end-expiration)".
     */
    public String stated() {
        List<String> sides = new ArrayList<>();
        if (!Double.isNaN(right)) {
            sides.add(name(right) + (mark == Mark.LIVER ? "" : " on the right"));
        }
        if (!Double.isNaN(left)) {
            sides.add(name(left) + " on the left");
        }
        return mark.name + " at " + String.join(" and ", sides) + " (" + mark.atExpiration + " at end-expiration)";
    }

    private static String name(double level) {
        double rounded = Math.round(TENTHS * level) / TENTHS;
        boolean lumbar = rounded >= StructureName.FIRST_LUMBAR;
        return Numbers.format(lumbar ? "L%.1f" : "T%.1f", lumbar ? rounded - StructureName.FIRST_LUMBAR + 1 : rounded);
    }

    /**
     * Height of the dome of a lung that the scan shows, else NaN. A scan that ends in the recess, well below the dome,
     * shows it; one that ends in the lung leaves a flat face there.
     */
    private static double dome(List<LungBase> bases, PatientBody scanned, Side side, SpineLevels spine) {
        double upperEnd = lobes(scanned, side).stream()
                .mapToDouble(s -> s.mesh().bounds()[5])
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
        boolean cut = isCutBelow(scanned, side);
        return bases.stream()
                .mapToDouble(LungBase::dome)
                .filter(top -> top < upperEnd - ABOVE_DOMES_MM)
                .filter(top ->
                        !cut || (top > lowerEnd(scanned, side) + SHOWN_DOME_MM && spine.levelAt(top) < LOWEST_DOME))
                .findFirst()
                .orElse(Double.NaN);
    }

    /** The base of a lung of the scan, completed where the scan does not cut it off; empty without that lung. */
    private static List<LungBase> bases(PatientBody scanned, PatientBody completed, Side side) {
        List<Structure> lobes = lobes(scanned, side);
        List<Structure> around = new ArrayList<>(isCutBelow(scanned, side) ? lobes : lobes(completed, side));
        around.addAll(ContactingOrgans.abdominal(scanned.thorax()));
        around.addAll(ContactingOrgans.between(scanned.thorax()));
        return lobes.isEmpty() ? List.of() : LungBase.of(new Thorax(completed.name(), around, List.of()));
    }

    /**
     * Top of a liver of the scan, else NaN: there the right dome lies. The scan shows it if it shows the right lung
     * above it or, without a right lung, if it does not end at the liver.
     */
    private static double topOfLiver(PatientBody scanned) {
        double upperEnd = lobes(scanned, Side.RIGHT).stream()
                .mapToDouble(s -> s.mesh().bounds()[5])
                .max()
                .orElse(Double.POSITIVE_INFINITY);
        return scanned.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.LIVER && !isCut(s, "S"))
                .mapToDouble(s -> s.structure().mesh().bounds()[5])
                .filter(top -> top < upperEnd - ABOVE_DOMES_MM)
                .max()
                .orElse(Double.NaN);
    }

    /** Height of the lowest point of a lung whose lower end the scan shows, else NaN. */
    private static double border(PatientBody scanned, Side side) {
        return isCutBelow(scanned, side) ? Double.NaN : lowerEnd(scanned, side);
    }

    /**
     * Height of the lowest point of a lung in a scan; NaN for none. Where the scan cuts it off, its border lies lower.
     */
    private static double lowerEnd(PatientBody scanned, Side side) {
        return lobes(scanned, side).stream()
                .mapToDouble(s -> s.mesh().bounds()[2])
                .min()
                .orElse(Double.NaN);
    }

    private static List<Structure> lobes(PatientBody body, Side side) {
        return body.thorax().structuresOf(StructureKind.LUNG).stream()
                .filter(s -> s.side() == side)
                .toList();
    }

    /** Whether a body as scanned has both lungs and none that the scan cuts off: their shape tells the level. */
    public static boolean showsWholeLungs(PatientBody scanned) {
        return Stream.of(Side.RIGHT, Side.LEFT)
                        .noneMatch(side -> lobes(scanned, side).isEmpty())
                && scanned.structures().stream()
                        .filter(s -> s.structure().kind() == StructureKind.LUNG)
                        .allMatch(PatientStructure::isComplete);
    }

    /** Whether the scan ends above the lower end of a lobe. */
    private static boolean isCutBelow(PatientBody scanned, Side side) {
        return scanned.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.LUNG
                        && s.structure().side() == side)
                .anyMatch(s -> isCut(s, "I"));
    }

    /** Whether the livers of a scan are as large as one that is whole, not one drawn about a target or a remnant. */
    private static boolean hasWholeLiver(PatientBody scanned, SpineLevels spine) {
        double apart = spine.spacingMm();
        double volume = scanned.thorax().structuresOf(StructureKind.LIVER).stream()
                .mapToDouble(s -> MeshMeasure.signedVolume(s.mesh()))
                .sum();
        return volume >= LEAST_LIVER * apart * apart * apart;
    }

    private static boolean isCut(PatientStructure structure, String end) {
        return structure.scan().filter(scan -> scan.cutAt().contains(end)).isPresent();
    }
}
