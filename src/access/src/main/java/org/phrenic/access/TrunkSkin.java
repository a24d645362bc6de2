package org.phrenic.access;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Surface;

/**
 * The skin about the liver: the skin of a body may have parts, such as an arm, that a needle to the liver is not in.
 */
public final class TrunkSkin {
    /** A scan that ends in the liver cuts skin and liver at heights that smoothing leaves this far apart, mm. */
    private static final double TOLERANCE_MM = 5;

    private TrunkSkin() {}

    /**
     * The only skin of a body or, of several, the one whose box holds the liver; empty if the body has none.
     *
     * @throws BadInputException if of several skins none or more than one holds the liver
     */
    public static Optional<Surface> of(List<Surface> surfaces) {
        List<Surface> skins =
                surfaces.stream().filter(s -> s.kind() == StructureKind.SKIN).toList();
        if (skins.size() < 2) {
            return skins.stream().findFirst();
        }
        List<Surface> around = skins.stream()
                .filter(skin -> surfaces.stream()
                        .anyMatch(s -> s.kind() == StructureKind.LIVER
                                && holds(skin.rest().bounds(), s.rest().bounds())))
                .toList();
        if (around.size() != 1) {
            throw new BadInputException("the body: found %d of the skins %s around the liver, expected one"
                    .formatted(around.size(), skins.stream().map(Surface::name).collect(Collectors.joining(", "))));
        }
        return Optional.of(around.get(0));
    }

    private static boolean holds(double[] skin, double[] liver) {
        for (int axis = 0; axis < 3; axis++) {
            if (liver[axis] < skin[axis] - TOLERANCE_MM || liver[3 + axis] > skin[3 + axis] + TOLERANCE_MM) {
                return false;
            }
        }
        return true;
    }
}
