package org.phrenic.ui.access;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleLoads;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.attempt.ZoneContacts;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.simulation.observe.Surface;

/** Records of attempts of which no more is known than their samples. */
public final class SampledAttempts {
    public static final TargetLesion TARGET = new TargetLesion(new double[] {-90, 0, 50}, 20);

    private SampledAttempts() {}

    /** A rehearsal of the first exercise with frames and pictures of nothing. */
    public static Rehearsal rehearsal(TargetingError... samples) {
        return rehearsal(List.of(), null, samples);
    }

    /** A rehearsal of the first exercise, with its access map and no picture of the needle. */
    static Rehearsal rehearsal(List<Surface> surfaces, AccessMap map, TargetingError... samples) {
        return new Rehearsal(
                RehearsalPlan.exercises().get(0),
                new BodySurfaces(surfaces),
                new TargetAccess(TARGET, map, List.of()),
                Optional.empty(),
                record(samples),
                ProbeUse.NONE,
                List.of(),
                "");
    }

    public static AttemptRecord record(TargetingError... samples) {
        return record(Needle.standard(), samples);
    }

    /** Samples that were taken with a needle. */
    public static AttemptRecord record(Needle needle, TargetingError... samples) {
        return new AttemptRecord(
                TARGET,
                needle,
                Set.of(),
                List.of(samples),
                List.of(),
                0,
                0,
                0,
                0,
                new ZoneContacts(Map.of(), Set.of()),
                List.of(),
                0,
                0,
                new double[3],
                0,
                0,
                new NeedleLoads(Map.of(), 0, 0, 0, 0));
    }
}
