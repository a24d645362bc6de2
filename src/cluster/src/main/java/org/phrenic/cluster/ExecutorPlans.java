package org.phrenic.cluster;

import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepStudy;

/** The plans of an executor. All tasks of a study in one process share its plan and with it the bodies. */
final class ExecutorPlans {
    private static final ConcurrentMap<String, SweepPlan> PLANS = new ConcurrentHashMap<>();

    private ExecutorPlans() {}

    /** @param study resolved text of a study */
    static SweepPlan of(String study) {
        return PLANS.computeIfAbsent(study, text -> SweepPlan.of(SweepStudy.parse("the study", text)));
    }
}
