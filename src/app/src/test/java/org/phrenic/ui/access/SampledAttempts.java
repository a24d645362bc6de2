package org.phrenic.ui.access;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleLoads;
import org.phrenic.access.attempt.TargetingError;

/** Records of attempts of which no more is known than their samples. */
public final class SampledAttempts {
    public static final TargetLesion TARGET = new TargetLesion(new double[] {-90, 0, 50}, 20);

    private SampledAttempts() {}

    public static AttemptRecord record(TargetingError... samples) {
        return new AttemptRecord(
                TARGET,
                Needle.standard(),
                Set.of(),
                List.of(samples),
                List.of(),
                0,
                0,
                0,
                0,
                Map.of(),
                List.of(),
                0,
                0,
                new double[3],
                0,
                0,
                new NeedleLoads(Map.of(), 0, 0, 0, 0));
    }
}
