package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;

/** Bases of two lungs of which one stands so high that it does not lie on the diaphragm. */
final class UnequalBases {
    /**
     * Height of the right dome above the left one, in parts of the height of the lungs above the lower dome. Twelve
     * pairs of lungs have 0.015 to 0.154, 0.07 in the mean: two virtual bodies, the scanned man, three other people,
     * and three patients at both ends of a deep breath.
     */
    private static final double RIGHT_HIGHER = 0.075;
    /**
     * A base that stands higher than that beside the other one by more than this part of that height, which is 35 to 50
     * mm, does not lie on the diaphragm: more than twice as far as any of those.
     */
    private static final double PARTED_SHARE = 0.2;

    private UnequalBases() {}

    /**
     * The side whose base stands far higher than beside the other one in people, if the scan labels no organ below it.
     * It does not lie on the diaphragm, for little but a paresis lifts one half of that so far, and no lung reaches
     * below its dome.
     */
    static Optional<Side> parted(Thorax body, List<LungBase> bases) {
        if (bases.size() < 2 || !bases.stream().allMatch(base -> base.isInScan() && base.liesOnDiaphragm())) {
            return Optional.empty();
        }
        double above = aboveUsual(bases.get(0), bases.get(1));
        LungBase higher = bases.get(above > 0 ? 0 : 1);
        List<Structure> organs = Stream.concat(
                        ContactingOrgans.abdominal(body).stream(), ContactingOrgans.between(body).stream())
                .toList();
        return Math.abs(above) > PARTED_SHARE * heightAbove(bases.get(0), bases.get(1))
                        && LungBase.inScan(body, organs)
                                .flatMap(with -> higher.below(with, LungBase.LEAST_ABOVE))
                                .isEmpty()
                ? Optional.of(higher.side())
                : Optional.empty();
    }

    /** Height by which the right dome stands higher than usual beside the left one, mm; negative for a higher left. */
    private static double aboveUsual(LungBase right, LungBase left) {
        return right.dome() - left.dome() - RIGHT_HIGHER * heightAbove(right, left);
    }

    /** Height of two lungs above the lower dome, mm. */
    private static double heightAbove(LungBase one, LungBase other) {
        return Math.max(one.apex(), other.apex()) - Math.min(one.dome(), other.dome());
    }

    /**
     * The bases of the lungs of a body of which one is known not to lie on the diaphragm: its dome is taken to stand as
     * usual beside the other one. A template's left dome goes down with its right one.
     *
     * @param parted side of {@link #parted}; empty if both lie on the diaphragm or organs show where it is
     */
    static List<LungBase> of(Thorax body, Optional<Side> parted) {
        List<LungBase> bases = LungBase.of(body);
        if (parted.isPresent() && bases.size() == 2) {
            double above = aboveUsual(bases.get(0), bases.get(1));
            LungBase high = bases.get(parted.get() == Side.RIGHT ? 0 : 1);
            high.lower(Math.max(0, high.side() == Side.RIGHT ? above : -above));
        }
        return bases.size() == 2 ? List.of(bases.get(0), bases.get(1).beside(bases.get(0))) : bases;
    }
}
