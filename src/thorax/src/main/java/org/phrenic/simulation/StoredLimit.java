package org.phrenic.simulation;

import java.util.Optional;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.file.ComputedArrays;

/**
 * The stability limit of a new scene as an array: highest frequency, its bound, least and largest damping, dashpots.
 */
final class StoredLimit {
    private static final int NUMBERS = 5;

    private StoredLimit() {}

    /** The limit of a system at its first state, which may be known. */
    static StabilityLimit of(ParticleSystem system, ComputedArrays computed) {
        int limits = system.layout().hasNodesApart() ? 2 : 1;
        double[] numbers = computed.get("stability limit", limits * NUMBERS, () -> {
            StabilityLimit limit = StabilityLimit.of(system);
            double[] all = new double[limits * NUMBERS];
            put(limit, all, 0);
            limit.apart().ifPresent(other -> put(other, all, NUMBERS));
            return all;
        });
        Optional<StabilityLimit> apart =
                limits == 2 ? Optional.of(get(numbers, NUMBERS, system, Optional.empty())) : Optional.empty();
        return get(numbers, 0, system, apart);
    }

    private static void put(StabilityLimit limit, double[] to, int at) {
        to[at] = limit.omegaMax();
        to[at + 1] = limit.omegaBound();
        to[at + 2] = limit.minDamping();
        to[at + 3] = limit.maxDamping();
        to[at + 4] = limit.maxDashpot();
    }

    private static StabilityLimit get(double[] of, int at, ParticleSystem system, Optional<StabilityLimit> apart) {
        return new StabilityLimit(of[at], of[at + 1], of[at + 2], of[at + 3], of[at + 4], system.hasContacts(), apart);
    }
}
